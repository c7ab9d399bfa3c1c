#include "view/window.hpp"

#include "state/errors.hpp"
#include "view/answers.hpp"
#include "view/canvases.hpp"
#include "view/draft.hpp"
#include "view/fineness.hpp"
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
#include <stop_token>
#include <utility>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace clack::view {

namespace {

using Seconds = std::chrono::duration<double>;
using Clock = std::chrono::steady_clock;

/// What a person has chosen to see.
struct Chosen {
    Look look;
    float azimuth = 0, elevation = 0, zoom = 0;
    Eigen::Vector3f target = Eigen::Vector3f::Zero();
    PixelSize size;

    bool operator==(Chosen const&) const = default;
};

/// All that a drawn picture depends on.
struct Drawn {
    std::uint64_t frame = 0;
    Chosen chosen;
    std::uint64_t asked = 0; // how much of what was asked for it shows
    float fineness = 0;

    bool shows_same(Drawn const& other) const {
        return frame == other.frame && chosen == other.chosen;
    }
};

/// Each picture takes and gives back some large pieces of memory, which the system would have to
/// fill with zeros each time: they are kept for the next.
void keep_memory() {
#ifdef __GLIBC__
    constexpr int piece_max = 32 << 20, spare_max = 256 << 20; // bytes; the first is its greatest
    mallopt(M_MMAP_THRESHOLD, piece_max);
    mallopt(M_TRIM_THRESHOLD, spare_max);
#endif
}

class Stage final : public Visited, private Hands {
public:
    Stage(Options const& options, std::unique_ptr<Source> source)
        : window_(options, *this), session_(options, std::move(source)) {
        if (!options.visit.empty()) visit_.emplace(options.visit);
    }

    void run() {
        canvases_.warm_up(picture_size());
        compose();
        window_.appear();
        while (!session_.closing && !window_.is_closing()) {
            window_.wait_for_events(is_busy() ? 0 : idle_wait);
            auto const begin = Clock::now();
            session_.look_at_latest();
            if (visit_) visit_->go_on(session_, *this);
            bool const news = draw_balls();
            if (news || is_panel_due(begin)) compose();
            Seconds const passed = Clock::now() - begin;
            deafness_ = std::max(deafness_, passed.count());
            if (!is_drawing())
                window_.wait_for_events(is_asked() ? short_wait : frame_time - passed.count());
        }
    }

    // What a visit does.
    void press(Key const& key) override {
        answers_.ask(Clock::now());
        key.action(session_);
    }
    void click(float x, float y) override {
        answers_.ask(Clock::now());
        session_.pick(x, y, picture_size());
    }
    void drag(float right, float down) override { on_drag(DragKind::turn, right, down); }
    void scroll(float notches) override {
        answers_.ask(Clock::now());
        session_.camera.zoom_by(std::pow(1.1f, notches));
    }
    bool is_up_to_date() const override {
        if (!whole_ || is_asked() || !save_to_.empty()) return false;
        return session_.shown->playing == Playing::yes || whole_->frame == session_.shown->number;
    }
    void save(std::string const& path) override { save_to_ = path; }
    double longest_deafness() override { return std::exchange(deafness_, 0); }
    double longest_answer() override { return answers_.longest(); }
    double drawing_seconds() const override { return canvases_.seconds_of_last(); }

private:
    static constexpr double idle_wait = 0.03, short_wait = 0.002, frame_time = 1.0 / 60; // [s]

    // What a person does.
    void on_key(int code) override {
        if (Key const* const key = key_of(code)) press(*key);
    }
    void on_click(float x, float y) override {
        if (x < static_cast<float>(picture_size().width)) click(x, y);
    }
    void on_drag(DragKind kind, float right, float down) override {
        answers_.ask(Clock::now());
        constexpr float radians_per_pixel = 0.006f;
        auto const height = static_cast<float>(picture_size().height);
        if (kind == DragKind::turn)
            session_.camera.orbit(radians_per_pixel * right, radians_per_pixel * down);
        else
            session_.camera.pan(right / height, -down / height);
    }
    void on_scroll(float notches) override { scroll(notches); }

    bool is_asked() const { return answers_.asked() > answered_; }
    bool is_drawing() const { return canvases_.is_drawing() || prepared_.valid(); }
    bool is_busy() const {
        return is_drawing() || visit_ || session_.shown->playing == Playing::yes ||
               session_.shown->equilibration < 1;
    }

    PixelSize picture_size() const {
        auto size = window_.size();
        if (session_.panel) size.width -= static_cast<int>(panel_width);
        return {std::max(size.width, 16), std::max(size.height, 16)};
    }

    Drawn wanted() const {
        auto const& camera = session_.camera;
        Drawn drawn{session_.shown->number,
                    {session_.look, camera.azimuth, camera.elevation, camera.zoom, camera.target,
                     picture_size()}};
        // What the player is still to do is not shown yet.
        bool const done = session_.player.has_done_all(*session_.shown);
        drawn.asked = done ? answers_.asked() : answered_;
        return drawn;
    }

    /// A new picture where there is news; a finer one where there is none. True when one is whole.
    bool draw_balls() {
        constexpr Seconds budget(0.012), preparation(0.004), at_rest(0.15);
        if (canvases_.is_drawing() && is_outdated()) canvases_.leave();
        if (prepared_.valid()) {
            if (is_outdated()) unwanted_.request_stop();
            if (prepared_.wait_for(preparation) == std::future_status::timeout) return false;
            auto prepared = prepared_.get();
            if (unwanted_.stop_requested()) return draw_balls(); // another one, at once
            canvases_.begin(std::move(prepared), under_way_.chosen.size, under_way_.fineness);
            if (canvases_.seconds_so_far() > budget.count() / 2) return false; // made a canvas
        } else if (!canvases_.is_drawing()) {
            auto next = wanted();
            bool const news = !whole_ || !whole_->shows_same(next);
            if (!news && canvases_.shown_fineness() >= finest) return false;
            bool const by_hand = is_asked() || Clock::now() - answers_.latest() < at_rest;
            if (by_hand && !news) return false;
            next.fineness = by_hand ? fineness_.for_hand() : fineness_.for_time();
            if (!news) next.fineness = finest;
            under_way_ = next;
            prepare();
            return false;
        }
        if (!canvases_.go_on(budget)) return false;
        fineness_.took(under_way_.fineness, preparation_.count() + canvases_.seconds_of_last());
        whole_ = under_way_;
        return true;
    }

    /// Whether a picture shows something that was asked for, for the first time.
    bool answers(Drawn const& picture) const { return picture.asked > answered_; }

    /// What a hand has made outdated would only be in the way of the next, if it is fine or no
    /// answer to anything.
    bool is_outdated() const {
        auto const now = wanted();
        bool const is_older = !(under_way_.chosen == now.chosen) || under_way_.asked < now.asked;
        return is_older && (under_way_.fineness > fineness_.for_hand() || !answers(under_way_));
    }

    /// Colours and order of many balls take a moment, in which the window is to answer.
    void prepare() {
        unwanted_ = std::stop_source();
        auto look = session_.look;
        look.flash_wait = flash_wait(*session_.shown);
        session_.player.want_news(); // while this picture is drawn
        auto const& size = under_way_.chosen.size;
        session_.camera.fit(size, overhang(session_.shown->frame.system));
        auto const policy = session_.shown->frame.system.count <= few_balls ? std::launch::deferred
                                                                            : std::launch::async;
        prepared_ =
            std::async(policy, [this, look, is_draft = under_way_.fineness <= coarsest,
                                most = fineness_.balls_of_draft(), unwanted = unwanted_.get_token(),
                                samples = finer(size, under_way_.fineness), shown = session_.shown,
                                camera = session_.camera] {
                auto const begin = Clock::now();
                Frame const& frame = shown->frame;
                auto picture = is_draft
                                   ? picture_of(frame, look,
                                                balls_of_draft(frame, look.cut, camera.eye(), most))
                                   : picture_of(frame, look);
                auto prepared = order_.prepare(std::move(picture), camera, samples, unwanted);
                preparation_ = Clock::now() - begin;
                return prepared;
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

    /// A draft is nothing to keep.
    bool is_saving() const {
        bool const playing = session_.shown->playing == Playing::yes;
        return !save_to_.empty() && whole_ && whole_->fineness >= (playing ? 1 : finest);
    }

    /// The panel takes as long to draw as the balls of a small scene: at most so often, unless
    /// somebody is at it.
    bool is_panel_due(Clock::time_point now) const {
        constexpr Seconds pause(0.1), pause_in_use(0.03), grace(0.06);
        // First comes a picture that answers and brings the panel with it, or stands in its way.
        if (is_drawing() && (answers(under_way_) || is_outdated()) &&
            now - answers_.latest() < grace)
            return false;
        bool const in_use = window_.was_touched() || is_asked();
        return is_saving() || now - composed_ > (in_use ? pause_in_use : pause);
    }

    void compose() {
        composed_ = Clock::now();
        canvases_.show(picture_size());
        window_.begin_panel();
        auto const before = session_.asked();
        draw_panel(session_, {canvases_.seconds_of_last(), canvases_.balls_drawn()});
        if (!(session_.asked() == before)) answers_.ask(composed_);
        window_.end_panel();
        if (is_saving()) {
            write_png(save_to_, read_pixels(window_.size(), 1));
            save_to_.clear();
        }
        window_.swap();
        auto const now = wanted();
        if (whole_) answered_ = whole_->shows_same(now) ? now.asked : whole_->asked;
        answers_.answer(answered_, Clock::now());
    }

    GlfwWindow window_; // first: it makes OpenGL current
    Session session_;
    Canvases canvases_;
    BallOrder order_;
    std::future<Prepared> prepared_; // after what it works with
    std::optional<Visit> visit_;
    std::optional<Drawn> whole_;
    Drawn under_way_;
    Fineness fineness_;
    Answers answers_;
    std::uint64_t answered_ = 0; // of what was asked
    Clock::time_point composed_;
    Seconds preparation_{0}; // of the picture under way
    std::stop_source unwanted_;
    double deafness_ = 0;
    std::string save_to_;
};

} // namespace

void show_window(Options const& options, std::unique_ptr<Source> source) {
    keep_memory();
    Stage(options, std::move(source)).run();
}

} // namespace clack::view
