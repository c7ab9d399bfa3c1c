#include "view/view.hpp"

#include "io/output_file.hpp"
#include "scenes/scene.hpp"
#include "state/errors.hpp"
#include "view/live.hpp"
#include "view/pictures.hpp"
#include "view/replay.hpp"
#include "view/window.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

namespace clack::view {

namespace {

std::unique_ptr<Source> source_of(Options const& options) {
    if (options.form == Form::scene)
        return std::make_unique<Live>(read_scene(options.path, options.overrides));
    return std::make_unique<Replay>(options.path);
}

void check(Options const& options) {
    if (!options.screenshot.empty()) require_writable(options.screenshot, Replacing::any_file);
    if (options.movie.empty()) return;
    require_writable(options.movie, Replacing::any_file);
    if (!options.movie.ends_with(".mp4"))
        throw InputError("movie = " + options.movie + ": must end in .mp4; choose another name");
    if (options.width % 2 != 0 || options.height % 2 != 0) {
        throw InputError(fmt::format("size = {}x{}: a movie's must be even; add a pixel",
                                     options.width, options.height));
    }
}

} // namespace

int view(Options const& options) {
    check(options);
    auto source = source_of(options);
    if (!options.screenshot.empty()) make_screenshot(*source, options);
    if (!options.movie.empty()) make_movie(*source, options);
    if (options.screenshot.empty() && options.movie.empty())
        show_window(options, std::move(source));
    return 0;
}

} // namespace clack::view
