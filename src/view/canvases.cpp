#include "view/canvases.hpp"

#include <utility>

namespace clack::view {

namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// A ball, a dot, and lines of both kinds.
Prepared little_of_everything() {
    Prepared prepared;
    DrawnBall const ball{0.5f, 0.5f, 0.5f, {}, 0};
    prepared.visible = {{ball}, {ball}};
    Eigen::Vector3f const from = Eigen::Vector3f::Zero(), to = Eigen::Vector3f::Ones();
    for (auto const hiding : {DrawnLine::Hiding::by_balls, DrawnLine::Hiding::never})
        prepared.picture.lines.push_back({from, to, {}, 1, hiding});
    return prepared;
}

} // namespace

void Canvases::warm_up(PixelSize window, std::initializer_list<int> samples) {
    for (int const finer : samples) {
        begin(little_of_everything(), window, finer);
        while (!go_on(std::chrono::hours(1))) {
        }
        show(window);
    }
    shown_.reset();
}

void Canvases::begin(Prepared prepared, PixelSize size, int samples) {
    auto const start = std::chrono::steady_clock::now();
    bool const fits = next_ && next_->samples == samples &&
                      next_->size.width == size.width * samples &&
                      next_->size.height == size.height * samples;
    if (!fits) next_ = std::make_unique<Canvas>(size, samples);
    glBindFramebuffer(GL_FRAMEBUFFER, next_->frame.name());
    drawing_.begin(std::move(prepared), next_->size, static_cast<float>(samples));
    glFinish(); // or the clearing would be done, and its time spent, with the first balls
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
