// An OpenGL 3.3 core context without a window: Mesa's OSMesa, or EGL without a surface where OSMesa is no
// more (Mesa 25.1 and later). Chosen when configuring; the drawing code never asks which it has.
#pragma once
#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/gl.h>
#include <GL/glext.h>

#include <memory>
#include <string>

namespace nutshell::picture {

class Context {
  public:
    /// @throws NoGraphics if there is no context to be had
    Context();
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    /// Makes it the current context of the calling thread.
    void use();
    /// "OSMesa" or "EGL".
    static std::string name();

  private:
    struct Handles;
    std::unique_ptr<Handles> handles_;
};

}  // namespace nutshell::picture
