#include "view/glfw_window.hpp"

#include "state/errors.hpp"

#include <epoxy/gl.h>

#include <GLFW/glfw3.h>

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace clack::view {

namespace {

std::string last_error = "no reason given";

[[noreturn]] void refuse(std::string const& what) {
    throw InputError("view: " + what + " (" + last_error +
                     "); use --screenshot or --movie, which need no display");
}

} // namespace

GlfwWindow::GlfwWindow(Options const& options, Hands& hands) : hands_(hands) {
    glfwSetErrorCallback([](int, char const* text) { last_error = text; });
    if (!glfwInit()) refuse("no window system");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    window_ = glfwCreateWindow(options.width, options.height, ("clack: " + options.path).c_str(),
                               nullptr, nullptr);
    if (!window_) {
        glfwTerminate();
        refuse("no window with OpenGL 3.3");
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(0); // the loop keeps its own time
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, key_callback);
    glfwSetCharCallback(window_, letter_callback);
    glfwSetMouseButtonCallback(window_, button_callback);
    glfwSetCursorPosCallback(window_, move_callback);
    glfwSetScrollCallback(window_, scroll_callback);
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr; // leaves no file behind
    ImGui::StyleColorsDark();
    ImGui_ImplGlfw_InitForOpenGL(window_, true); // calls the callbacks above too
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

GlfwWindow::~GlfwWindow() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

GlfwWindow& GlfwWindow::of(GLFWwindow* window) {
    return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window));
}

void GlfwWindow::key_callback(GLFWwindow* window, int key, int, int action, int) {
    of(window).panels_due_ = panels_to_settle;
    if (action == GLFW_RELEASE || ImGui::GetIO().WantTextInput) return;
    if (key != GLFW_KEY_SLASH) of(window).hands_.on_key(key);
}

/// The question mark lies elsewhere on each keyboard.
void GlfwWindow::letter_callback(GLFWwindow* window, unsigned letter) {
    if (letter == '?' && !ImGui::GetIO().WantTextInput) of(window).hands_.on_key(GLFW_KEY_SLASH);
}

void GlfwWindow::button_callback(GLFWwindow* window, int button, int action, int) {
    auto& self = of(window);
    self.panels_due_ = panels_to_settle;
    if (action == GLFW_PRESS) {
        if (ImGui::GetIO().WantCaptureMouse) return;
        self.pressed_ = button;
        self.moved_ = 0;
        return;
    }
    constexpr double still = 4; // a hand that clicks moves by so many pixels
    if (self.pressed_ == GLFW_MOUSE_BUTTON_LEFT && button == self.pressed_ && self.moved_ < still)
        self.hands_.on_click(static_cast<float>(self.x_), static_cast<float>(self.y_));
    self.pressed_ = -1;
}

void GlfwWindow::move_callback(GLFWwindow* window, double x, double y) {
    auto& self = of(window);
    self.panels_due_ = panels_to_settle;
    double const right = x - self.x_, down = y - self.y_;
    self.x_ = x;
    self.y_ = y;
    if (self.pressed_ < 0) return;
    self.moved_ += std::abs(right) + std::abs(down);
    self.hands_.on_drag(self.pressed_ == GLFW_MOUSE_BUTTON_LEFT ? DragKind::turn : DragKind::move,
                        static_cast<float>(right), static_cast<float>(down));
}

void GlfwWindow::scroll_callback(GLFWwindow* window, double, double notches) {
    of(window).panels_due_ = panels_to_settle;
    if (!ImGui::GetIO().WantCaptureMouse) of(window).hands_.on_scroll(static_cast<float>(notches));
}

void GlfwWindow::appear() { glfwShowWindow(window_); }

bool GlfwWindow::is_closing() const { return glfwWindowShouldClose(window_) != 0; }

PixelSize GlfwWindow::size() const {
    PixelSize size;
    glfwGetFramebufferSize(window_, &size.width, &size.height);
    return size;
}

void GlfwWindow::wait_for_events(double seconds) {
    if (seconds > 0) {
        glfwWaitEventsTimeout(seconds);
    } else {
        glfwPollEvents();
    }
}

void GlfwWindow::begin_panel() {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void GlfwWindow::end_panel() {
    panels_due_ = std::max(panels_due_ - 1, 0);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void GlfwWindow::swap() { glfwSwapBuffers(window_); }

} // namespace clack::view
