#include "state/errors.hpp"
#include "view/view.hpp"

namespace clack::view {

int view(Options const& options) {
    throw InputError("view " + options.path +
                     ": this clack was built without the viewer; install libglfw3-dev, "
                     "libimgui-dev, libepoxy-dev, libegl-dev and libpng-dev, and build it again");
}

} // namespace clack::view
