#include "view/view.hpp"

#include "cli/commands.hpp"
#include "cli/memory.hpp"
#include "io/trajectory_reader.hpp"
#include "scenes/scene.hpp"
#include "state/errors.hpp"

namespace clack {

int view_command(view::Options options) {
    bool const pictures = !options.screenshot.empty() || !options.movie.empty();
    options.form = options.path.ends_with(".h5") || is_hdf5(options.path) ? view::Form::trajectory
                                                                          : view::Form::scene;
    if (options.form == view::Form::scene) {
        constexpr std::size_t bytes_beside = 600; // frames under way, states to go back to
        options.require_room = [](Scene const& scene) { require_memory(scene, bytes_beside); };
        options.require_room(read_scene(options.path, options.overrides));
    } else if (!options.overrides.empty()) {
        throw InputError(options.path + ": is a trajectory, so --set has no effect; view a scene");
    }
    if (pictures && !options.visit.empty())
        throw InputError("visit = " + options.visit + ": is for the window; leave out the picture");
    return view::view(options);
}

} // namespace clack
