#include "view/pictures.hpp"

#include "state/errors.hpp"
#include "view/appearance.hpp"
#include "view/images.hpp"
#include "view/movie.hpp"
#include "view/offscreen.hpp"
#include "view/png_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <numbers>

namespace clack::view {

namespace {

Camera camera_for(Options const& options, System const& system, PixelSize size) {
    constexpr auto degree = static_cast<float>(std::numbers::pi / 180);
    Camera camera;
    camera.azimuth = degree * static_cast<float>(options.azimuth);
    camera.elevation = degree * static_cast<float>(options.elevation);
    camera.fit(size, overhang(system));
    camera.zoom = static_cast<float>(options.zoom);
    return camera;
}

Look look_of(Options const& options) {
    Look look;
    look.colouring = options.colouring;
    look.background = options.background.value_or(Background::light);
    look.cut = {options.clip_from, options.clip};
    return look;
}

/// A file shows what it holds and nothing else.
void require_time(Source const& source, Options const& options, double time) {
    if (time >= source.first_time() && time <= source.last_time()) return;
    throw InputError(fmt::format("time = {:g}: {} holds times from {:g} to {:g}", time,
                                 options.path, source.first_time(), source.last_time()));
}

/// Of a file without collisions a picture is that of a frame, and says so when it was not asked
/// for.
void tell_other_time(Source const& source, Options const& options, double asked) {
    if (source.time() == asked) return;
    fmt::print(stderr,
               "clack: {} holds no collisions: for time {:g} its frame of time {:g} is drawn\n",
               options.path, asked, source.time());
}

std::vector<double> times_of(Source const& source, Options const& options) {
    if (!options.times.empty()) return options.times;
    return {std::isfinite(source.last_time()) ? source.last_time() : source.first_time()};
}

} // namespace

void make_screenshot(Source& source, Options const& options) {
    PixelSize const size{options.width, options.height};
    constexpr int samples = 3;
    Offscreen offscreen(size, samples);
    auto const camera = camera_for(options, source.system(), size);
    std::vector<Pixels> pictures;
    for (double const time : times_of(source, options)) {
        require_time(source, options, time);
        source.seek(time);
        tell_other_time(source, options, time);
        auto const start = std::make_shared<Eigen::Matrix3Xd const>(source.start_places());
        auto const picture = picture_of(frame_of(source, start), look_of(options));
        pictures.push_back(offscreen.draw(picture, camera));
    }
    write_png(options.screenshot, joined(pictures));
}

void make_movie(Source& source, Options const& options) {
    PixelSize const size{options.width, options.height};
    constexpr int samples = 2;
    double const begin = options.times.empty() ? source.first_time() : options.times.front();
    require_time(source, options, begin);
    Offscreen offscreen(size, samples);
    auto const camera = camera_for(options, source.system(), size);
    Look look = look_of(options);
    look.flashes = Visible::yes;
    constexpr double flash_seconds = 0.08;
    look.flash_wait = flash_seconds * options.speed;
    Movie movie(options.movie, size, options.frame_rate);
    auto const frames = static_cast<long>(std::ceil(options.duration * options.frame_rate));
    source.seek(begin);
    if (!source.remark().empty())
        fmt::print(stderr, "clack: {}: {}\n", options.path, source.remark());
    auto const start = std::make_shared<Eigen::Matrix3Xd const>(source.start_places());
    for (long frame = 0; frame < frames; ++frame) {
        double const seconds = static_cast<double>(frame) / options.frame_rate;
        double const time = begin + seconds * options.speed;
        if (time > source.last_time()) break;
        source.seek(time);
        movie.add(offscreen.draw(picture_of(frame_of(source, start), look), camera));
    }
    movie.finish();
}

} // namespace clack::view
