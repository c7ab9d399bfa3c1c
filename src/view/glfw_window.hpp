#pragma once
// A window of GLFW with a panel of Dear ImGui.

#include "view/camera.hpp"
#include "view/view.hpp"

struct GLFWwindow;

namespace clack::view {

enum class DragKind { turn, move };

/// Told what a person does with keys and mouse, where the panel does not want it.
class Hands {
public:
    virtual ~Hands() = default;
    virtual void on_key(int code) = 0;
    virtual void on_click(float x, float y) = 0; // pixels from the upper left
    virtual void on_drag(DragKind kind, float right, float down) = 0;
    virtual void on_scroll(float notches) = 0;
};

class GlfwWindow {
public:
    /// Throws InputError where there is no window system or no OpenGL 3.3.
    GlfwWindow(Options const& options, Hands& hands);
    GlfwWindow(GlfwWindow const&) = delete;
    GlfwWindow& operator=(GlfwWindow const&) = delete;
    ~GlfwWindow();

    /// Until then the window is not on the screen.
    void appear();
    bool is_closing() const;
    PixelSize size() const;
    void wait_for_events(double seconds);
    /// Whether mouse or keys have done anything that the panel may not show yet.
    bool was_touched() const { return panels_due_ > 0; }
    void begin_panel();
    void end_panel();
    void swap();

private:
    static constexpr int panels_to_settle =
        3; // what opens is measured in one and drawn in the next

    static GlfwWindow& of(GLFWwindow* window);
    static void key_callback(GLFWwindow* window, int key, int, int action, int);
    static void letter_callback(GLFWwindow* window, unsigned letter);
    static void button_callback(GLFWwindow* window, int button, int action, int);
    static void move_callback(GLFWwindow* window, double x, double y);
    static void scroll_callback(GLFWwindow* window, double, double notches);

    GLFWwindow* window_ = nullptr;
    Hands& hands_;
    int panels_due_ = panels_to_settle;
    int pressed_ = -1; // the button that is held down
    double x_ = 0, y_ = 0, moved_ = 0;
};

} // namespace clack::view
