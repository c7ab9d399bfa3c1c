#include "view/session.hpp"

#include <GLFW/glfw3.h>

#include <algorithm>

namespace clack::view {

namespace {

void toggle(Visible& what) { what = what == Visible::yes ? Visible::no : Visible::yes; }

template <class Is> Key const* find_key(Is const& is) {
    auto const found = std::find_if(keys().begin(), keys().end(), is);
    return found == keys().end() ? nullptr : &*found;
}

} // namespace

std::vector<Key> const& keys() {
    static std::vector<Key> const all{
        {GLFW_KEY_SPACE, "space", "play, pause", [](Session& s) { s.toggle_playing(); }},
        {GLFW_KEY_RIGHT, "right", "step to the next collision",
         [](Session& s) { s.player.step(); }},
        {GLFW_KEY_LEFT, "left", "step back to the collision before",
         [](Session& s) { s.player.step_back(); }},
        {GLFW_KEY_UP, "up", "twice as fast", [](Session& s) { s.change_speed(2); }},
        {GLFW_KEY_DOWN, "down", "half as fast", [](Session& s) { s.change_speed(0.5); }},
        {GLFW_KEY_1, "1", "speed 1", [](Session& s) { s.player.set_speed(1); }},
        {GLFW_KEY_HOME, "home", "back to the start",
         [](Session& s) { s.player.seek(s.shown->first_time); }},
        {GLFW_KEY_S, "s", "start again with another seed",
         [](Session& s) { s.restart_with_another_seed(); }},
        {GLFW_KEY_C, "c", "next colouring", [](Session& s) { s.next_colouring(); }},
        {GLFW_KEY_F, "f", "flash at collisions", [](Session& s) { toggle(s.look.flashes); }},
        {GLFW_KEY_N, "n", "mark the pair about to collide",
         [](Session& s) { toggle(s.look.next_pair); }},
        {GLFW_KEY_W, "w", "the cube's edges", [](Session& s) { toggle(s.look.cube); }},
        {GLFW_KEY_X, "x", "cut the cube open", [](Session& s) { s.toggle_cut(); }},
        {GLFW_KEY_V, "v", "cut from the next face", [](Session& s) { s.cut_from_next_face(); }},
        {GLFW_KEY_LEFT_BRACKET, "[", "cut deeper", [](Session& s) { s.move_cut(-0.02); }},
        {GLFW_KEY_RIGHT_BRACKET, "]", "cut less deep", [](Session& s) { s.move_cut(0.02); }},
        {GLFW_KEY_T, "t", "let go of the ball", [](Session& s) { s.player.trace(-1); }},
        {GLFW_KEY_R, "r", "the first view again", [](Session& s) { s.reset_camera(); }},
        {GLFW_KEY_B, "b", "light or dark",
         [](Session& s) {
             s.look.background =
                 s.look.background == Background::light ? Background::dark : Background::light;
         }},
        {GLFW_KEY_P, "p", "the panel", [](Session& s) { s.panel = !s.panel; }},
        {GLFW_KEY_SLASH, "?", "this list", [](Session& s) { s.help = !s.help; }},
        {GLFW_KEY_ESCAPE, "escape", "close", [](Session& s) { s.closing = true; }},
    };
    return all;
}

Key const* key_of(int code) {
    return find_key([&](Key const& key) { return key.code == code; });
}

Key const* key_of(std::string const& name) {
    return find_key([&](Key const& key) { return key.name == name; });
}

} // namespace clack::view
