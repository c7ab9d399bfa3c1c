#include "view/graphics.hpp"

#include <array>
#include <stdexcept>

namespace clack::view::gl {

namespace {

GLuint compiled(GLenum kind, std::string const& source) {
    GLuint const shader = glCreateShader(kind);
    char const* const text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint good = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good) return shader;
    std::array<char, 400> log{};
    glGetShaderInfoLog(shader, log.size(), nullptr, log.data());
    throw std::runtime_error("OpenGL refuses a shader: " + std::string(log.data()));
}

} // namespace

Program make_program(std::string const& vertex, std::string const& fragment) {
    Program program(glCreateProgram());
    for (GLuint const shader :
         {compiled(GL_VERTEX_SHADER, vertex), compiled(GL_FRAGMENT_SHADER, fragment)}) {
        glAttachShader(program.name(), shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program.name());
    GLint good = 0;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &good);
    if (!good) throw std::runtime_error("OpenGL refuses to link a program");
    return program;
}

Buffer make_buffer() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return Buffer(name);
}

Vertices make_vertices() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    return Vertices(name);
}

} // namespace clack::view::gl
