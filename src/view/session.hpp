#pragma once
// What the person at the window has chosen, and what can be asked for there.

#include "view/appearance.hpp"
#include "view/camera.hpp"
#include "view/player.hpp"
#include "view/view.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace clack::view {

/// What the panel can change of a scene.
struct SceneChoice {
    int count = 0;
    float packing_fraction = 0;
    int seed = 0;
    std::string method = "auto";
};

class Session {
public:
    Session(Options options, std::unique_ptr<Source> source);

    void toggle_playing();
    void change_speed(double factor);
    void next_colouring();
    void toggle_cut();
    void move_cut(double by);
    void cut_from_next_face();
    void reset_camera();
    void restart(); // with `choice`
    void restart_with_another_seed();
    /// The ball that a pixel shows, or none; its path is traced from now on.
    void pick(float x, float y, PixelSize size);

    /// What was asked for until now, with hand or key, but for the camera.
    struct Asked {
        std::uint64_t tasks; // of the player
        Look look;
        bool operator==(Asked const&) const = default;
    };
    Asked asked() const { return {player.tasks_asked(), look}; }

    /// Looks what the player has to show.
    void look_at_latest() { shown = player.latest(); }

    Options options;
    std::string title; // of the scene, or the file's name
    SceneChoice choice;
    Player player;
    std::shared_ptr<Shown const> shown;
    Camera camera;
    Look look;
    bool panel = true, help = false, closing = false;

private:
    double cut_share_ = 0.5; // where the plane is when it is switched on
};

/// A key, what it is called, what it does.
struct Key {
    int code; // GLFW's
    char const* name;
    char const* effect;
    void (*action)(Session&);
};

std::vector<Key> const& keys();
/// The key of a code or a name; null where there is none.
Key const* key_of(int code);
Key const* key_of(std::string const& name);

} // namespace clack::view
