#include "gl.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace nutshell::picture::gl {

namespace {

GLuint compile(GLenum stage, const std::string& source) {
    const GLuint id = glCreateShader(stage);
    const char* text = source.c_str();
    glShaderSource(id, 1, &text, nullptr);
    glCompileShader(id);
    GLint good = 0;
    glGetShaderiv(id, GL_COMPILE_STATUS, &good);
    if (!good) {
        std::array<char, 2000> words{};
        glGetShaderInfoLog(id, GLsizei(words.size()), nullptr, words.data());
        glDeleteShader(id);
        throw std::runtime_error(std::string("picture: OpenGL does not compile a shader: ") + words.data());
    }
    return id;
}

}  // namespace

Program::Program(const std::string& vertex, const std::string& fragment) : id_(glCreateProgram()) {
    for (const GLuint shader : {compile(GL_VERTEX_SHADER, vertex), compile(GL_FRAGMENT_SHADER, fragment)}) {
        glAttachShader(id_, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(id_);
    GLint good = 0;
    glGetProgramiv(id_, GL_LINK_STATUS, &good);
    if (!good) {
        std::array<char, 2000> words{};
        glGetProgramInfoLog(id_, GLsizei(words.size()), nullptr, words.data());
        glDeleteProgram(id_);
        throw std::runtime_error(std::string("picture: OpenGL does not link a program: ") + words.data());
    }
}

Buffer::Buffer(const void* data, std::size_t bytes, const std::vector<int>& floats,
               const std::vector<std::uint32_t>& indices) {
    glGenVertexArrays(1, &array_);
    glBindVertexArray(array_);
    glGenBuffers(1, &buffer_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(bytes), data, GL_STATIC_DRAW);
    std::size_t stride = 0, offset = 0;
    for (int n : floats) stride += std::size_t(n) * sizeof(float);
    for (std::size_t i = 0; i < floats.size(); ++i) {
        glEnableVertexAttribArray(GLuint(i));
        glVertexAttribPointer(GLuint(i), floats[i], GL_FLOAT, GL_FALSE, GLsizei(stride),
                              reinterpret_cast<const void*>(offset));
        offset += std::size_t(floats[i]) * sizeof(float);
    }
    if (indices.empty()) return;
    glGenBuffers(1, &indices_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size() * sizeof indices[0]), indices.data(),
                 GL_STATIC_DRAW);
}

Buffer::~Buffer() {
    glDeleteBuffers(1, &buffer_);
    glDeleteBuffers(1, &indices_);
    glDeleteVertexArrays(1, &array_);
}

Canvas::Canvas(int width, int height) : width_(width), height_(height) {
    glGenFramebuffers(1, &frame_);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    auto attach = [&](GLuint& buffer, GLenum format, GLenum place) {
        glGenRenderbuffers(1, &buffer);
        glBindRenderbuffer(GL_RENDERBUFFER, buffer);
        glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
    };
    attach(colours_, GL_RGBA8, GL_COLOR_ATTACHMENT0);
    attach(depths_, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw std::runtime_error("picture: OpenGL has no room for " + std::to_string(width) + " x " +
                                 std::to_string(height) + " samples");
    }
}

Canvas::~Canvas() {
    glDeleteFramebuffers(1, &frame_);
    glDeleteRenderbuffers(1, &colours_);
    glDeleteRenderbuffers(1, &depths_);
}

void Canvas::use() const {
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glViewport(0, 0, width_, height_);
}

std::vector<unsigned char> Canvas::pixels() const {
    const std::size_t row = 3 * std::size_t(width_), rows = std::size_t(height_);
    std::vector<unsigned char> upside_down(row * rows), out(row * rows);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, upside_down.data());
    for (std::size_t y = 0; y < rows; ++y) {
        std::copy_n(&upside_down[row * (rows - 1 - y)], row, &out[row * y]);
    }
    return out;
}

ShadowMap::ShadowMap(int side) : side_(side) {
    glGenTextures(1, &depths_);
    glBindTexture(GL_TEXTURE_2D, depths_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, side, side, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                 nullptr);
    for (int filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
        glTexParameteri(GL_TEXTURE_2D, GLenum(filter), GL_LINEAR);
    }
    for (int edge : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
        glTexParameteri(GL_TEXTURE_2D, GLenum(edge), GL_CLAMP_TO_EDGE);  // sun_view leaves air: lit
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glGenFramebuffers(1, &frame_);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depths_, 0);
    const GLenum none = GL_NONE;
    glDrawBuffers(1, &none);
    glReadBuffer(GL_NONE);
}

ShadowMap::~ShadowMap() {
    glDeleteFramebuffers(1, &frame_);
    glDeleteTextures(1, &depths_);
}

void ShadowMap::use() const {
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glViewport(0, 0, side_, side_);
}

}  // namespace nutshell::picture::gl
