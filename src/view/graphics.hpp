#pragma once
// Names of OpenGL that give back what they stand for.

#include <epoxy/gl.h>

#include <string>
#include <utility>

namespace clack::view::gl {

/// Owns one object. `Release` gives it back; the context must be current then.
template <void (*release)(GLuint)> class Object {
public:
    Object() = default;
    explicit Object(GLuint name) : name_(name) {}
    Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Object& operator=(Object&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    Object(Object const&) = delete;
    Object& operator=(Object const&) = delete;
    ~Object() {
        if (name_) release(name_);
    }
    GLuint name() const { return name_; }

private:
    GLuint name_ = 0;
};

inline void release_program(GLuint name) { glDeleteProgram(name); }
inline void release_buffer(GLuint name) { glDeleteBuffers(1, &name); }
inline void release_vertices(GLuint name) { glDeleteVertexArrays(1, &name); }
inline void release_renderbuffer(GLuint name) { glDeleteRenderbuffers(1, &name); }
inline void release_framebuffer(GLuint name) { glDeleteFramebuffers(1, &name); }
inline void release_texture(GLuint name) { glDeleteTextures(1, &name); }

using Program = Object<release_program>;
using Buffer = Object<release_buffer>;
using Vertices = Object<release_vertices>;
using Renderbuffer = Object<release_renderbuffer>;
using Framebuffer = Object<release_framebuffer>;
using Texture = Object<release_texture>;

/// Throws std::runtime_error with the compiler's first words: a bug of ours or of the driver.
Program make_program(std::string const& vertex, std::string const& fragment);
Buffer make_buffer();
Vertices make_vertices();

} // namespace clack::view::gl
