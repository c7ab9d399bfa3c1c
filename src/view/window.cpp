#include "view/window.hpp"

#include "state/errors.hpp"
#include "view/canvases.hpp"
#include "view/glfw_window.hpp"
#include "view/images.hpp"
#include "view/panel.hpp"
#include "view/png_file.hpp"
#include "view/session.hpp"
#include "view/visit.hpp"

#include <algorithm>
#include <cmath>
#include <future>
#include <optional>
#include <utility>

namespace clack::view {

namespace {

using Seconds = std::chrono::duration<double>;
using Clock = std::chrono::steady_clock;

/// All that a drawn picture depends on.
struct Drawn {
    std::uint64_t frame = 0;
    Look look;
    float azimuth = 0, elevation = 0, zoom = 0;
    Eigen::Vector3f target = Eigen::Vector3f::Zero();
    PixelSize size;

    bool operator==(Drawn const&) const = default;
};

class Stage final : public Visited, private Hands {
public:
    Stage(Options const& options, std::unique_ptr<Source> source)
        : window_(options, *this), session_(options, std::move(source)) {
        if (!options.visit.empty()) visit_.emplace(options.visit);
    }

    void run() {
        canvases_.warm_up(picture_size(), {1, samples_at_rest});
        compose();
        window_.appear();
        while (!session_.closing && !window_.is_closing()) {
            window_.wait_for_events(is_busy() ? 0 : idle_wait);
            auto const begin = Clock::now();
            session_.look_at_latest();
            if (visit_) visit_->go_on(session_, *this);
            draw_balls();
            compose();
            Seconds const passed = Clock::now() - begin;
            deafness_ = std::max(deafness_, passed.count());
            if (!canvases_.is_drawing()) window_.wait_for_events(frame_time - passed.count());
        }
    }

    // What a visit does.
    void press(std::string const& name) override {
        for (Key const& key : keys()) {
            if (name == key.name) key.action(session_);
        }
    }
    void click(float x, float y) override { session_.pick(x, y, picture_size()); }
    void drag(float right, float down) override { turn(right, down); }
    void scroll(float notches) override { session_.camera.zoom_by(std::pow(1.1f, notches)); }
    bool is_up_to_date() const override {
        bool const playing = session_.shown->playing == Playing::yes;
        return whole_ && (playing || whole_->frame == session_.shown->number);
    }
    void save(std::string const& path) override { save_to_ = path; }
    double longest_deafness() override { return std::exchange(deafness_, 0); }
    double drawing_seconds() const override { return canvases_.seconds_of_last(); }

private:
    static constexpr double idle_wait = 0.03, frame_time = 1.0 / 60; // [s]

    // What a person does.
    void on_key(int code) override {
        for (Key const& key : keys()) {
            if (key.code == code) key.action(session_);
        }
    }
    void on_click(float x, float y) override {
        if (x < static_cast<float>(picture_size().width)) click(x, y);
    }
    void on_drag(DragKind kind, float right, float down) override {
        auto const height = static_cast<float>(picture_size().height);
        if (kind == DragKind::turn)
            turn(right, down);
        else
            session_.camera.pan(right / height, -down / height);
    }
    void on_scroll(float notches) override { scroll(notches); }

    void turn(float right, float down) {
        constexpr float radians_per_pixel = 0.006f;
        session_.camera.orbit(radians_per_pixel * right, radians_per_pixel * down);
    }

    bool is_busy() const {
        return canvases_.is_drawing() || visit_ || session_.shown->playing == Playing::yes ||
               session_.shown->equilibration < 1;
    }

    PixelSize picture_size() const {
        auto size = window_.size();
        if (session_.panel) size.width -= static_cast<int>(panel_width);
        return {std::max(size.width, 16), std::max(size.height, 16)};
    }

    Drawn wanted() const {
        auto const& camera = session_.camera;
        return {session_.shown->number, session_.look, camera.azimuth,
                camera.elevation,       camera.zoom,   camera.target,
                picture_size()};
    }

    /// A new picture where there is news; a finer one where there is none.
    void draw_balls() {
        constexpr Seconds budget(0.012);
        if (prepared_.valid()) {
            if (prepared_.wait_for(Seconds(0)) == std::future_status::timeout) return;
            canvases_.begin(prepared_.get(), under_way_.size, samples_under_way_);
            if (canvases_.seconds_so_far() > budget.count() / 2) return; // a canvas was made
        } else if (!canvases_.is_drawing()) {
            auto const now = wanted();
            bool const news = !whole_ || !(*whole_ == now);
            if (!news && canvases_.shown_samples() >= samples_at_rest) return;
            under_way_ = now;
            samples_under_way_ = news ? samples_in_motion_ : samples_at_rest;
            prepare();
            return;
        }
        if (!canvases_.go_on(budget)) return;
        bool const coarse = canvases_.shown_samples() == 1;
        constexpr double quick = 0.005, slow = 0.025;
        if (coarse && canvases_.seconds_of_last() < quick) samples_in_motion_ = samples_at_rest;
        if (!coarse && canvases_.seconds_of_last() > slow) samples_in_motion_ = 1;
        whole_ = under_way_;
    }

    /// Colours and order of many balls take a moment, in which the window is to answer.
    void prepare() {
        auto look = session_.look;
        look.flash_wait = flash_wait(*session_.shown);
        session_.player.want_news(); // while this picture is drawn
        session_.camera.fit(under_way_.size, overhang(session_.shown->frame.system));
        PixelSize const samples{under_way_.size.width * samples_under_way_,
                                under_way_.size.height * samples_under_way_};
        constexpr std::int64_t few = 3000;
        auto const policy =
            session_.shown->frame.system.count <= few ? std::launch::deferred : std::launch::async;
        prepared_ = std::async(
            policy, [this, look, samples, shown = session_.shown, camera = session_.camera] {
                return order_.prepare(picture_of(shown->frame, look), camera, samples);
            });
        if (policy == std::launch::deferred) prepared_.wait();
    }

    /// A flash fades in a blink, and sooner where balls collide so often that all would glow.
    static double flash_wait(Shown const& shown) {
        constexpr double blink = 0.12, share_max = 0.2; // [s], of the balls
        double wait = blink * shown.speed;
        auto const& sample = shown.frame.sample;
        auto const collisions = static_cast<double>(2 * sample.tallies.ball_collisions +
                                                    sample.tallies.wall_collisions);
        if (collisions > 0) {
            auto const balls = static_cast<double>(shown.frame.system.count);
            wait = std::min(wait, share_max * balls * sample.time / collisions);
        }
        return std::max(wait, 1e-12);
    }

    void compose() {
        canvases_.show(picture_size());
        window_.begin_panel();
        draw_panel(session_, {canvases_.seconds_of_last(), canvases_.balls_drawn()});
        window_.end_panel();
        if (!save_to_.empty()) {
            write_png(save_to_, read_pixels(window_.size(), 1));
            save_to_.clear();
        }
        window_.swap();
    }

    static constexpr int samples_at_rest = 2;

    GlfwWindow window_; // first: it makes OpenGL current
    Session session_;
    Canvases canvases_;
    BallOrder order_;
    std::future<Prepared> prepared_; // after what it works with
    int samples_under_way_ = 1;
    std::optional<Visit> visit_;
    std::optional<Drawn> whole_;
    Drawn under_way_;
    int samples_in_motion_ = 1;
    double deafness_ = 0;
    std::string save_to_;
};

} // namespace

void show_window(Options const& options, std::unique_ptr<Source> source) {
    Stage(options, std::move(source)).run();
}

} // namespace clack::view
