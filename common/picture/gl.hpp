// The few OpenGL objects that pictures need, released when they go out of scope.
#pragma once
#include <Eigen/Dense>
#include <cstdint>
#include <string>
#include <vector>

#include "context.hpp"

namespace nutshell::picture::gl {

/// A linked program. @throws std::runtime_error with the driver's words if it does not compile
class Program {
  public:
    Program(const std::string& vertex, const std::string& fragment);
    ~Program() { glDeleteProgram(id_); }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void use() const { glUseProgram(id_); }
    void set(const char* name, int value) const { glUniform1i(at(name), value); }
    void set(const char* name, double value) const { glUniform1f(at(name), float(value)); }
    void set(const char* name, const Eigen::Vector2f& v) const { glUniform2fv(at(name), 1, v.data()); }
    void set(const char* name, const Eigen::Vector3f& v) const { glUniform3fv(at(name), 1, v.data()); }
    void set(const char* name, const Eigen::Matrix3f& m) const {
        glUniformMatrix3fv(at(name), 1, GL_FALSE, m.data());
    }
    void set(const char* name, const Eigen::Matrix4f& m) const {
        glUniformMatrix4fv(at(name), 1, GL_FALSE, m.data());
    }

  private:
    GLint at(const char* name) const { return glGetUniformLocation(id_, name); }
    GLuint id_ = 0;
};

/// Vertices on their way through OpenGL, attributes of `floats` each one after another, and their indices if
/// any.
class Buffer {
  public:
    Buffer(const void* data, std::size_t bytes, const std::vector<int>& floats,
           const std::vector<std::uint32_t>& indices = {});
    ~Buffer();
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;
    void use() const { glBindVertexArray(array_); }

  private:
    GLuint array_ = 0, buffer_ = 0, indices_ = 0;
};

/// Where to draw: colours and depths. @throws std::runtime_error if the driver refuses the size
class Canvas {
  public:
    Canvas(int width, int height);
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;
    void use() const;
    /// Rows from the top, three bytes a pixel.
    std::vector<unsigned char> pixels() const;

  private:
    int width_, height_;
    GLuint frame_ = 0, colours_ = 0, depths_ = 0;
};

/// Depths as seen from the sun; what lies outside is lit.
class ShadowMap {
  public:
    explicit ShadowMap(int side);
    ~ShadowMap();
    ShadowMap(const ShadowMap&) = delete;
    ShadowMap& operator=(const ShadowMap&) = delete;
    void use() const;
    void bind() const { glBindTexture(GL_TEXTURE_2D, depths_); }

  private:
    int side_;
    GLuint frame_ = 0, depths_ = 0;
};

}  // namespace nutshell::picture::gl
