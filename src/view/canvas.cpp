#include "view/canvas.hpp"

#include "state/errors.hpp"

#include <array>
#include <cmath>

namespace clack::view {

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

} // namespace

Canvas::Canvas(PixelSize in_samples) : size(in_samples) {
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
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth.name());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw InputError("view: OpenGL refuses a picture of this size; choose a smaller one");
}

Pixels read_pixels(PixelSize size, int samples) {
    static Light const light;
    auto const width = static_cast<std::size_t>(size.width);
    auto const height = static_cast<std::size_t>(size.height);
    auto const finer = static_cast<std::size_t>(samples);
    std::vector<std::uint8_t> rgba(4 * width * height * finer * finer);
    glReadPixels(0, 0, size.width * samples, size.height * samples, GL_RGBA, GL_UNSIGNED_BYTE,
                 rgba.data());
    Pixels pixels{size, {}};
    pixels.rgb.reserve(3 * width * height);
    for (std::size_t row = height; row-- > 0;) { // OpenGL begins at the bottom
        for (std::size_t column = 0; column < width; ++column) {
            std::array<std::uint32_t, 3> sum{};
            for (std::size_t k = 0; k < finer * finer; ++k) {
                auto const x = column * finer + k % finer, y = row * finer + k / finer;
                for (std::size_t c = 0; c < 3; ++c)
                    sum[c] += light.of(rgba[4 * (y * width * finer + x) + c]);
            }
            for (std::uint32_t const all : sum)
                pixels.rgb.push_back(
                    light.on_screen(all / static_cast<std::uint32_t>(finer * finer)));
        }
    }
    return pixels;
}

} // namespace clack::view
