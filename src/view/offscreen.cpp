#include "view/offscreen.hpp"

#include "state/errors.hpp"

#include <epoxy/egl.h>

#include <array>
#include <cmath>

namespace clack::view {

struct Offscreen::Context {
    Context() {
        // Asked for under its older name: libepoxy aborts on that of EGL 1.5.
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
    explicit Target(PixelSize size) {
        GLuint names[2] = {0, 0}, framebuffer = 0;
        glGenRenderbuffers(2, names);
        colour = gl::Renderbuffer(names[0]);
        depth = gl::Renderbuffer(names[1]);
        glGenFramebuffers(1, &framebuffer);
        frame = gl::Framebuffer(framebuffer);
        glBindRenderbuffer(GL_RENDERBUFFER, colour.name());
        glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size.width, size.height);
        glBindRenderbuffer(GL_RENDERBUFFER, depth.name());
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, size.width, size.height);
        glBindFramebuffer(GL_FRAMEBUFFER, frame.name());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                  colour.name());
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                  depth.name());
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw InputError("view: OpenGL refuses a picture of this size; choose a smaller one");
    }

    gl::Renderbuffer colour, depth;
    gl::Framebuffer frame;
    Drawing drawing;
};

namespace {

/// A screen's numbers are about the square root of the light: means are taken of the light.
class Light {
public:
    Light() {
        for (std::size_t i = 0; i < 256; ++i) {
            double const share = static_cast<double>(i) / 255;
            light_[i] = static_cast<std::uint32_t>(std::lround(65535 * std::pow(share, 2.2)));
        }
        for (std::size_t i = 0; i < screen_.size(); ++i) {
            double const share = static_cast<double>(i) / static_cast<double>(screen_.size() - 1);
            screen_[i] = static_cast<std::uint8_t>(std::lround(255 * std::pow(share, 1 / 2.2)));
        }
    }
    std::uint32_t of(std::uint8_t screen) const { return light_[screen]; }
    std::uint8_t on_screen(std::uint32_t light) const { return screen_[light >> 2]; }

private:
    std::array<std::uint32_t, 256> light_{};
    std::array<std::uint8_t, 16384> screen_{};
};

/// The means of samples x samples, and the first row on top.
Pixels scaled_down(std::vector<std::uint8_t> const& rgba, PixelSize size, int samples) {
    static Light const light;
    Pixels pixels{size, {}};
    pixels.rgb.resize(3 * static_cast<std::size_t>(size.width) *
                      static_cast<std::size_t>(size.height));
    auto const stride =
        4 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(samples);
    auto const many = static_cast<std::uint32_t>(samples * samples);
    std::size_t to = 0;
    for (int row = size.height - 1; row >= 0; --row) {
        for (int column = 0; column < size.width; ++column) {
            std::array<std::uint32_t, 3> sum{};
            for (int k = 0; k < samples * samples; ++k) {
                auto const x = static_cast<std::size_t>(column * samples + k % samples);
                auto const y = static_cast<std::size_t>(row * samples + k / samples);
                for (std::size_t c = 0; c < 3; ++c)
                    sum[c] += light.of(rgba[y * stride + 4 * x + c]);
            }
            for (std::uint32_t const all : sum) pixels.rgb[to++] = light.on_screen(all / many);
        }
    }
    return pixels;
}

} // namespace

Offscreen::Offscreen(PixelSize size, int samples)
    : size_(size), samples_(samples), context_(std::make_unique<Context>()),
      target_(std::make_unique<Target>(PixelSize{size.width * samples, size.height * samples})) {}

Offscreen::~Offscreen() = default;

Pixels Offscreen::draw(Picture const& picture, Camera const& camera) {
    PixelSize const drawn{size_.width * samples_, size_.height * samples_};
    glBindFramebuffer(GL_FRAMEBUFFER, target_->frame.name());
    target_->drawing.begin(picture, camera, drawn, static_cast<float>(samples_));
    target_->drawing.finish();
    std::vector<std::uint8_t> rgba(4 * static_cast<std::size_t>(drawn.width) *
                                   static_cast<std::size_t>(drawn.height));
    glReadPixels(0, 0, drawn.width, drawn.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    return scaled_down(rgba, size_, samples_);
}

} // namespace clack::view
