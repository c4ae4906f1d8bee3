#include "post/chart/offscreen_window.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkObjectFactory.h>

#include <array>
#include <new>

#include "share/error.hpp"

namespace graincrack {

namespace {

/// One OpenGL context that belongs to no window system.
class EglContext {
public:
    EglContext() {
        const auto get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
        if (get_display == nullptr) refuse("this EGL has no eglGetPlatformDisplayEXT");
        display_ = get_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
        if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) != EGL_TRUE) {
            refuse("EGL has no surfaceless platform");
        }
        eglBindAPI(EGL_OPENGL_API);
        constexpr std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (eglChooseConfig(display_, wanted.data(), &config, 1, &count) != EGL_TRUE || count < 1) {
            refuse("EGL offers no OpenGL configuration");
        }
        constexpr std::array<EGLint, 7> version{
            EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 2, EGL_CONTEXT_OPENGL_PROFILE_MASK,
            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
        context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version.data());
        if (context_ == EGL_NO_CONTEXT) refuse("EGL offers no OpenGL 3.2 context");
        make_current();
    }
    ~EglContext() {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
    }
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    void make_current() { eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_); }
    [[nodiscard]] bool is_current() const { return eglGetCurrentContext() == context_; }

private:
    [[noreturn]] static void refuse(const std::string& why) {
        throw OutputError("picture: cannot draw without a display: " + why +
                          "; install libegl-mesa0 and libgl1-mesa-dri, or write an .svg");
    }
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

/// VTK's window for a foreign context, with the context it lives in.
class OffscreenWindow : public vtkGenericOpenGLRenderWindow {
public:
    static OffscreenWindow* New();

    void MakeCurrent() override { context_.make_current(); }
    bool IsCurrent() override { return context_.is_current(); }

protected:
    OffscreenWindow() {
        SetReadyForRendering(true);
        SetOwnContext(0);
    }
    ~OffscreenWindow() override { Finalize(); }

private:
    EglContext context_;
};
vtkStandardNewMacro(OffscreenWindow);

}  // namespace

vtkSmartPointer<vtkRenderWindow> make_offscreen_window(int width, int height) {
    auto window = vtkSmartPointer<OffscreenWindow>::New();
    window->InitializeFromCurrentContext();
    window->SetOffScreenRendering(1);
    window->SetSize(width, height);
    return window;
}

}  // namespace graincrack
