#include "view/canvases.hpp"

#include <algorithm>
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

PixelSize finer(PixelSize window, float fineness) {
    auto const times = [&](int pixels) {
        return std::max(static_cast<int>(fineness * static_cast<float>(pixels)), 1);
    };
    return {times(window.width), times(window.height)};
}

void Canvases::warm_up(PixelSize window) {
    for (float const fineness : {coarsest, 1.f, finest}) {
        begin(little_of_everything(), window, fineness);
        while (!go_on(std::chrono::hours(1))) {
        }
        show(window);
    }
    shown_.reset();
}

void Canvases::begin(Prepared prepared, PixelSize window, float fineness) {
    auto const start = std::chrono::steady_clock::now();
    auto const size = finer(window, fineness);
    take_canvas(size);
    next_fineness_ = fineness;
    glBindFramebuffer(GL_FRAMEBUFFER, next_->frame.name());
    drawing_.begin(std::move(prepared), size, fineness);
    glFinish(); // or the clearing would be done, and its time spent, with the first balls
    is_drawing_ = true;
    seconds_ = seconds_since(start);
}

void Canvases::take_canvas(PixelSize size) {
    if (next_ && next_->size == size) return;
    constexpr std::size_t spare_max = 4; // and the one shown: two of each of the finenesses in use
    if (next_) spare_.push_back(std::move(next_));
    auto const fitting =
        std::find_if(spare_.begin(), spare_.end(),
                     [&](std::unique_ptr<Canvas> const& canvas) { return canvas->size == size; });
    if (fitting != spare_.end()) {
        next_ = std::move(*fitting);
        spare_.erase(fitting);
        return;
    }
    if (spare_.size() > spare_max) spare_.erase(spare_.begin());
    next_ = std::make_unique<Canvas>(size);
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
    shown_fineness_ = next_fineness_;
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
