#include "view/offscreen.hpp"

#include "state/errors.hpp"

#include <epoxy/egl.h>

#include <array>

namespace clack::view {

struct Offscreen::Context {
    Context() {
        // Asked for under its older name, and only where it is: libepoxy aborts on what it lacks.
        if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base") ||
            !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
            refuse();
        display_ =
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr)) refuse();
        constexpr std::array<EGLint, 7> wanted{EGL_CONTEXT_MAJOR_VERSION,
                                               3,
                                               EGL_CONTEXT_MINOR_VERSION,
                                               3,
                                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                               EGL_NONE};
        if (!eglBindAPI(EGL_OPENGL_API)) refuse();
        context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted.data());
        if (context_ == EGL_NO_CONTEXT ||
            !eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
            refuse();
        }
    }
    Context(Context const&) = delete;
    Context& operator=(Context const&) = delete;
    ~Context() {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
        eglTerminate(display_);
    }

private:
    [[noreturn]] static void refuse() {
        throw InputError("view: no OpenGL 3.3 for drawing without a display (EGL on a surfaceless "
                         "platform); install libegl-mesa0 and libgl1-mesa-dri");
    }

    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

struct Offscreen::Target {
    explicit Target(PixelSize in_samples) : canvas(in_samples) {}
    Canvas canvas;
    Drawing drawing;
    BallOrder order;
};

Offscreen::Offscreen(PixelSize size, int samples)
    : size_(size), samples_(samples), context_(std::make_unique<Context>()),
      target_(std::make_unique<Target>(PixelSize{size.width * samples, size.height * samples})) {}

Offscreen::~Offscreen() = default;

Pixels Offscreen::draw(Picture const& picture, Camera const& camera) {
    auto const& canvas = target_->canvas;
    glBindFramebuffer(GL_FRAMEBUFFER, canvas.frame.name());
    target_->drawing.begin(target_->order.prepare(picture, camera, canvas.size), canvas.size,
                           static_cast<float>(samples_));
    target_->drawing.finish();
    return read_pixels(size_, samples_);
}

} // namespace clack::view
