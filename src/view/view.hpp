#pragma once
// The viewer as the command line sees it: one call. Everything else in this folder is behind it,
// and a build without the viewer's libraries has `absent.cpp` in place of all the rest.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace clack {
struct Scene;
}

namespace clack::view {

/// What a ball's colour tells.
enum class Colouring { speed, energy, collisions, side };

enum class Background { light, dark };

/// The cube's faces, as they lie when the camera stands in front: x = 0 and side, y, z.
enum class Face { left, right, front, back, bottom, top };

/// What a path leads to.
enum class Form { scene, trajectory };

/// What to look at, and how. With neither a screenshot nor a movie a window opens.
struct Options {
    std::string path;
    Form form = Form::scene; // a scene is run live, a trajectory replayed
    std::vector<std::string> overrides;

    std::string screenshot;    // PNG to write; a picture for each time
    std::string movie;         // MP4 to write
    std::vector<double> times; // of the pictures, or of the movie's start  [time]
    int width = 1000, height = 750;
    double duration = 10; // of the movie  [s]
    int frame_rate = 60;  // of the movie  [1 / s]
    double speed = 1;     // simulated time in a second [time / s]

    Colouring colouring = Colouring::speed;
    std::optional<Background> background; // unless given: light for pictures, dark for the window
    double azimuth = -60, elevation = 20, zoom = 1; // of the camera [degrees], [degrees], -
    double clip = 1;              // share of the cube's depth that is drawn; the rest is cut away,
    Face clip_from = Face::front; // beginning at this face
    /// Throws InputError for a scene that this machine has no room for.
    std::function<void(Scene const&)> require_room = [](Scene const&) {};
    std::string visit; // a file of what to do in the window, one command a line
};

/// Shows, draws or films. Returns the exit code; throws InputError, LawBroken or WriteError.
int view(Options const& options);

} // namespace clack::view
