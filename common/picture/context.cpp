#include "context.hpp"

#include <cstdlib>

#include "nutshell/picture/image.hpp"

#ifdef PICTURE_OSMESA
#include <GL/osmesa.h>
#else
#include <EGL/egl.h>
#include <EGL/eglext.h>
#endif

// Mesa keeps a few hundred bytes for itself until the process ends; the leak sanitizer asks here whom to
// forgive.
#if defined(__SANITIZE_ADDRESS__)
#define PICTURE_LEAKS_ARE_COUNTED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define PICTURE_LEAKS_ARE_COUNTED
#endif
#endif
#ifdef PICTURE_LEAKS_ARE_COUNTED
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() {
    return "print_suppressions=0";
}
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libOSMesa\nleak:libEGL\nleak:libgallium\nleak:swrast_dri\n";
}
#endif

namespace nutshell::picture {

#ifdef PICTURE_OSMESA

struct Context::Handles {
    OSMesaContext context = nullptr;
    unsigned stub = 0;  // OSMesa wants a buffer of its own; we draw into framebuffer objects
};

Context::Context() : handles_(std::make_unique<Handles>()) {
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              24,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
    handles_->context = OSMesaCreateContextAttribs(attributes, nullptr);
    if (!handles_->context) throw NoGraphics("OSMesa gives no OpenGL 3.3 context");
    use();
}

Context::~Context() {
    OSMesaDestroyContext(handles_->context);
}

void Context::use() {
    if (!OSMesaMakeCurrent(handles_->context, &handles_->stub, GL_UNSIGNED_BYTE, 1, 1)) {
        throw NoGraphics("OSMesa cannot make its context current");
    }
}

std::string Context::name() {
    return "OSMesa";
}

#else

struct Context::Handles {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
};

Context::Context() : handles_(std::make_unique<Handles>()) {
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);  // the same picture on every machine, whatever its GPU
    const auto get_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (get_display)
        handles_->display = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    const std::string driver = " (is Mesa's software driver installed? Debian package libgl1-mesa-dri)";
    if (handles_->display == EGL_NO_DISPLAY || !eglInitialize(handles_->display, nullptr, nullptr)) {
        throw NoGraphics("EGL has no display without a surface" + driver);
    }
    eglBindAPI(EGL_OPENGL_API);
    const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(handles_->display, wanted, &config, 1, &count) || count < 1) {
        throw NoGraphics("EGL has no configuration for OpenGL" + driver);
    }
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 3,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 3,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    handles_->context = eglCreateContext(handles_->display, config, EGL_NO_CONTEXT, attributes);
    if (handles_->context == EGL_NO_CONTEXT) throw NoGraphics("EGL gives no OpenGL 3.3 context" + driver);
    use();
}

Context::~Context() {
    eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(handles_->display, handles_->context);  // the display itself belongs to the process
}

void Context::use() {
    eglBindAPI(EGL_OPENGL_API);  // each thread has its own
    if (!eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, handles_->context)) {
        throw NoGraphics("EGL cannot make its context current");
    }
}

std::string Context::name() {
    return "EGL";
}

#endif

}  // namespace nutshell::picture
