#include "view/session.hpp"

#include "scenes/scene.hpp"
#include "simulation/model_choice.hpp"
#include "view/images.hpp"
#include "view/live.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace clack::view {

namespace {

std::optional<Scene> scene_of(Options const& options) {
    if (options.form != Form::scene) return std::nullopt;
    return read_scene(options.path, options.overrides);
}

std::string title_of(Options const& options) {
    auto const scene = scene_of(options);
    if (scene && !scene->title.empty()) return scene->title;
    return std::filesystem::path(options.path).filename().string();
}

SceneChoice choice_of(Options const& options, System const& system) {
    SceneChoice choice;
    choice.count = static_cast<int>(system.count);
    choice.packing_fraction = static_cast<float>(system.packing_fraction());
    if (auto const scene = scene_of(options)) {
        choice.seed = static_cast<int>(scene->seed % 1'000'000'000);
        choice.method = name_of(scene->method);
    }
    return choice;
}

} // namespace

Session::Session(Options the_options, std::unique_ptr<Source> source)
    : options(std::move(the_options)), title(title_of(options)),
      choice(choice_of(options, source->system())),
      // NOLINTNEXTLINE(bugprone-use-after-move): choice stands before player
      player(std::move(source), options.speed) {
    look.colouring = options.colouring;
    look.background = options.background.value_or(Background::dark);
    look.cut = {options.clip_from, options.clip};
    look.flashes = Visible::yes;
    reset_camera();
    look_at_latest();
}

void Session::reset_camera() {
    constexpr auto degree = static_cast<float>(std::numbers::pi / 180);
    camera = Camera{};
    camera.azimuth = degree * static_cast<float>(options.azimuth);
    camera.elevation = degree * static_cast<float>(options.elevation);
    camera.zoom = static_cast<float>(options.zoom);
}

void Session::toggle_playing() {
    if (shown->playing == Playing::yes) {
        player.pause();
    } else {
        player.play();
    }
}

void Session::change_speed(double factor) { player.set_speed(shown->speed * factor); }

void Session::next_colouring() {
    look.colouring = static_cast<Colouring>((static_cast<int>(look.colouring) + 1) % 4);
}

void Session::toggle_cut() {
    if (look.cut.is_whole()) {
        look.cut.share = cut_share_;
    } else {
        cut_share_ = look.cut.share;
        look.cut.share = 1;
    }
}

void Session::move_cut(double by) { look.cut.share = std::clamp(look.cut.share + by, 0.0, 1.0); }

/// And opens the cube if it is whole, or nothing would be seen of it.
void Session::cut_from_next_face() {
    look.cut.from = static_cast<Face>((static_cast<int>(look.cut.from) + 1) % 6);
    if (look.cut.is_whole()) toggle_cut();
}

/// What the scene says stays, but for what was changed.
void Session::restart() {
    if (options.form != Form::scene) {
        player.seek(shown->first_time);
        return;
    }
    auto overrides = options.overrides;
    System const& system = shown->frame.system;
    if (choice.count != system.count ||
        std::abs(choice.packing_fraction - system.packing_fraction()) > 1e-6) {
        overrides.push_back(fmt::format("balls.count={}", choice.count));
        overrides.push_back(fmt::format("container.packing_fraction={:.6}",
                                        static_cast<double>(choice.packing_fraction)));
        options.overrides = overrides;
    }
    overrides.push_back(fmt::format("run.seed={}", choice.seed));
    overrides.push_back("run.method=" + choice.method);
    player.restart([path = options.path, overrides,
                    require_room = options.require_room]() -> std::unique_ptr<Source> {
        auto scene = read_scene(path, overrides);
        require_room(scene);
        return std::make_unique<Live>(std::move(scene));
    });
}

void Session::restart_with_another_seed() {
    ++choice.seed;
    restart();
}

/// The nearest ball that the ray of sight meets.
void Session::pick(float x, float y, PixelSize size) {
    Ray const ray = camera.ray_through(x, y, size);
    Frame const& frame = shown->frame;
    auto const radius = static_cast<float>(frame.system.diameter / 2 / frame.system.side);
    float nearest = std::numeric_limits<float>::infinity();
    std::int64_t found = -1;
    for (Eigen::Index ball = 0; ball < frame.system.count; ++ball) {
        auto const meets = [&](Eigen::Vector3f const& place) {
            if (look.cut.hides(place)) return;
            Eigen::Vector3f const away = place - ray.origin;
            float const along = away.dot(ray.direction);
            if (along >= nearest || (away - along * ray.direction).squaredNorm() > radius * radius)
                return;
            nearest = along;
            found = ball;
        };
        each_place(frame.system, frame.snapshot.positions.col(ball), meets);
    }
    player.trace(found);
}

} // namespace clack::view
