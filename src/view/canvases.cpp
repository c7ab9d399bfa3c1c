#include "view/canvases.hpp"

#include <utility>

namespace clack::view {

namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

} // namespace

void Canvases::begin(Prepared prepared, PixelSize size, int samples) {
    auto const start = std::chrono::steady_clock::now();
    bool const fits = next_ && next_->samples == samples &&
                      next_->size.width == size.width * samples &&
                      next_->size.height == size.height * samples;
    if (!fits) next_ = std::make_unique<Canvas>(size, samples);
    glBindFramebuffer(GL_FRAMEBUFFER, next_->frame.name());
    drawing_.begin(std::move(prepared), next_->size, static_cast<float>(samples));
    is_drawing_ = true;
    seconds_ = seconds_since(start);
}

bool Canvases::go_on(std::chrono::duration<double> budget) {
    if (!is_drawing_) return false;
    auto const start = std::chrono::steady_clock::now();
    glBindFramebuffer(GL_FRAMEBUFFER, next_->frame.name());
    is_drawing_ = !drawing_.go_on(budget);
    if (!is_drawing_) glFinish();
    seconds_ += seconds_since(start);
    if (is_drawing_) return false;
    seconds_of_last_ = seconds_;
    balls_drawn_ = drawing_.drawn_ball_count();
    std::swap(shown_, next_);
    return true;
}

void Canvases::show(PixelSize window) const {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (!shown_) {
        glClear(GL_COLOR_BUFFER_BIT);
        return;
    }
    glBindFramebuffer(GL_READ_FRAMEBUFFER, shown_->frame.name());
    bool const same_size =
        shown_->size.width == window.width && shown_->size.height == window.height;
    glBlitFramebuffer(0, 0, shown_->size.width, shown_->size.height, 0, 0, window.width,
                      window.height, GL_COLOR_BUFFER_BIT, same_size ? GL_NEAREST : GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

} // namespace clack::view
