#include "view/drawing.hpp"

#include "view/shaders.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace clack::view {

namespace {

void attribute(GLuint index, GLint count, GLenum type, GLboolean scaled, std::size_t stride,
               std::size_t offset, GLuint divisor) {
    glEnableVertexAttribArray(index);
    // OpenGL takes an offset into a buffer for a pointer.
    auto const* const place =
        reinterpret_cast<void const*>(offset); // NOLINT(performance-no-int-to-ptr)
    glVertexAttribPointer(index, count, type, scaled, static_cast<GLsizei>(stride), place);
    glVertexAttribDivisor(index, divisor);
}

void describe_balls(gl::Vertices const& vertices, gl::Buffer const& buffer, GLuint divisor) {
    glBindVertexArray(vertices.name());
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    attribute(0, 3, GL_FLOAT, GL_FALSE, sizeof(DrawnBall), offsetof(DrawnBall, x), divisor);
    attribute(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(DrawnBall), offsetof(DrawnBall, colour),
              divisor);
}

void set(gl::Program const& program, char const* name, float value) {
    glUniform1f(glGetUniformLocation(program.name(), name), value);
}

void set(gl::Program const& program, char const* name, Eigen::Vector3f const& value) {
    glUniform3fv(glGetUniformLocation(program.name(), name), 1, value.data());
}

} // namespace

Eigen::Vector3f background_colour(Background background) {
    return background == Background::light ? Eigen::Vector3f(0.975f, 0.975f, 0.97f)
                                           : Eigen::Vector3f(0.085f, 0.095f, 0.115f);
}

Drawing::Drawing()
    : ball_(gl::make_program(std::string(shaders::common) + shaders::ball_vertex,
                             std::string(shaders::common) + shaders::lighting +
                                 shaders::ball_fragment)),
      dot_(gl::make_program(std::string(shaders::common) + shaders::dot_vertex,
                            std::string(shaders::common) + shaders::lighting +
                                shaders::dot_fragment)),
      line_(gl::make_program(std::string(shaders::common) + shaders::line_vertex,
                             std::string(shaders::common) + shaders::line_fragment)),
      corner_vertices_(gl::make_vertices()), dot_vertices_(gl::make_vertices()),
      line_vertices_(gl::make_vertices()), ball_buffer_(gl::make_buffer()),
      line_buffer_(gl::make_buffer()) {
    describe_balls(corner_vertices_, ball_buffer_, 1);
    describe_balls(dot_vertices_, ball_buffer_, 0);
    glBindVertexArray(line_vertices_.name());
    glBindBuffer(GL_ARRAY_BUFFER, line_buffer_.name());
    attribute(0, 3, GL_FLOAT, GL_FALSE, sizeof(Strip), offsetof(Strip, from), 1);
    attribute(1, 3, GL_FLOAT, GL_FALSE, sizeof(Strip), offsetof(Strip, to), 1);
    attribute(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Strip), offsetof(Strip, colour), 1);
    attribute(3, 1, GL_FLOAT, GL_FALSE, sizeof(Strip), offsetof(Strip, width), 1);
    glBindVertexArray(0);
}

void Drawing::set_uniforms(gl::Program const& program) {
    glUseProgram(program.name());
    Eigen::Matrix4f const projection = camera_.projection(size_);
    glUniformMatrix4fv(glGetUniformLocation(program.name(), "projection"), 1, GL_FALSE,
                       projection.data());
    set(program, "eye", camera_.eye());
    set(program, "up", camera_.up());
    set(program, "background", background_colour(picture_.background));
    set(program, "radius", picture_.radius);
    set(program, "nearest", nearest_);
    set(program, "farthest", farthest_);
    set(program, "pixels", camera_.focal_length() * static_cast<float>(size_.height));
    glUniform2f(glGetUniformLocation(program.name(), "size"), static_cast<float>(size_.width),
                static_cast<float>(size_.height));
}

void Drawing::begin(Prepared prepared, PixelSize size, float pixels_per_pixel) {
    picture_ = std::move(prepared.picture);
    camera_ = prepared.camera;
    visible_ = std::move(prepared.visible);
    size_ = size;
    pixels_per_pixel_ = pixels_per_pixel;
    float const to_centre = (camera_.eye() - Eigen::Vector3f::Constant(0.5f)).norm();
    constexpr float half_diagonal = 0.9f;
    float const reach = half_diagonal + 3 * picture_.radius; // with balls across faces
    nearest_ = std::max(to_centre - reach, 0.f);
    farthest_ = to_centre + reach;
    drawn_ = 0;
    done_ = false;
    glViewport(0, 0, size.width, size.height);
    auto const behind = background_colour(picture_.background);
    glClearColor(behind.x(), behind.y(), behind.z(), 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

bool Drawing::go_on(std::chrono::duration<double> budget) {
    auto const begin = std::chrono::steady_clock::now();
    glViewport(0, 0, size_.width, size_.height);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_PROGRAM_POINT_SIZE);
    while (!done_) {
        if (drawn_ < drawn_ball_count()) {
            draw_some_balls();
        } else {
            draw_lines(DrawnLine::Hiding::by_balls);
            glDisable(GL_DEPTH_TEST);
            draw_lines(DrawnLine::Hiding::never);
            draw_rings();
            done_ = true;
        }
        if (std::chrono::steady_clock::now() - begin > budget) break;
    }
    glDisable(GL_DEPTH_TEST);
    return done_;
}

void Drawing::finish() {
    while (!go_on(std::chrono::hours(1))) {
    }
}

/// As many at a time as take a few milliseconds: the window is deaf meanwhile.
void Drawing::draw_some_balls() {
    constexpr double aim = 0.004; // [s]
    constexpr std::size_t least = 64, most = 65536;
    auto const begin = std::chrono::steady_clock::now();
    bool const near = drawn_ < visible_.near.size();
    auto const& balls = near ? visible_.near : visible_.dots;
    auto const first = near ? drawn_ : drawn_ - visible_.near.size();
    auto const count = std::min(at_a_time_, balls.size() - first);
    glBindVertexArray((near ? corner_vertices_ : dot_vertices_).name());
    draw_balls(near ? ball_ : dot_, balls, first, count, near ? GL_TRIANGLE_STRIP : GL_POINTS);
    drawn_ += count;
    glFinish(); // or what was spent would not be known
    double const spent =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (spent > 2 * aim) at_a_time_ = std::max(at_a_time_ / 2, least);
    if (spent < aim && count == at_a_time_) at_a_time_ = std::min(at_a_time_ * 2, most);
}

void Drawing::draw_balls(gl::Program const& program, std::vector<DrawnBall> const& balls,
                         std::size_t first, std::size_t count, GLenum form) {
    set_uniforms(program);
    glBindBuffer(GL_ARRAY_BUFFER, ball_buffer_.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(count * sizeof(DrawnBall)),
                 balls.data() + first, GL_STREAM_DRAW);
    if (form == GL_POINTS) {
        glDrawArrays(form, 0, static_cast<GLsizei>(count));
    } else {
        glDrawArraysInstanced(form, 0, 4, static_cast<GLsizei>(count));
    }
    glBindVertexArray(0);
}

/// Cut into pieces: the depth of a piece is nearly even, and those behind the eye are left out.
void Drawing::add_line(std::vector<Strip>& strips, DrawnLine const& line) const {
    Eigen::Vector3f const whole = line.to - line.from;
    int const pieces = std::clamp(static_cast<int>(32 * whole.norm()), 1, 64);
    auto const in_front = [&](Eigen::Vector3f const& place) {
        return (camera_.eye() - place).dot(camera_.towards_eye()) > 0.02f;
    };
    for (int piece = 0; piece < pieces; ++piece) {
        auto const share = [&](int k) {
            return static_cast<float>(k) / static_cast<float>(pieces);
        };
        Eigen::Vector3f const from = line.from + share(piece) * whole;
        Eigen::Vector3f const to = line.from + share(piece + 1) * whole;
        if (!in_front(from) || !in_front(to)) continue;
        std::uint8_t const fades = line.hiding == DrawnLine::Hiding::by_balls ? 255 : 0;
        strips.push_back({from, to, line.colour, fades, line.width * pixels_per_pixel_});
    }
}

void Drawing::draw_lines(DrawnLine::Hiding hiding) {
    std::vector<Strip> strips;
    for (DrawnLine const& line : picture_.lines) {
        if (line.hiding == hiding) add_line(strips, line);
    }
    draw_strips(strips);
}

void Drawing::draw_rings() {
    constexpr int corners = 48;
    float const radius =
        1.25f * picture_.radius + 0.002f * camera_.distance() / camera_.focal_length();
    for (DrawnRing const& ring : picture_.rings) {
        std::vector<Strip> strips;
        auto const corner = [&](int k) -> Eigen::Vector3f {
            float const angle = 2 * std::numbers::pi_v<float> * static_cast<float>(k) / corners;
            return ring.centre +
                   ring.width * radius *
                       (std::cos(angle) * camera_.right() + std::sin(angle) * camera_.up());
        };
        for (int k = 0; k < corners; ++k) {
            add_line(strips,
                     {corner(k), corner(k + 1), ring.colour, 2.f, DrawnLine::Hiding::never});
        }
        draw_strips(strips);
    }
}

void Drawing::draw_strips(std::vector<Strip> const& strips) {
    if (strips.empty()) return;
    set_uniforms(line_);
    glBindVertexArray(line_vertices_.name());
    glBindBuffer(GL_ARRAY_BUFFER, line_buffer_.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(strips.size() * sizeof(Strip)),
                 strips.data(), GL_STREAM_DRAW);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(strips.size()));
    glBindVertexArray(0);
}

} // namespace clack::view
