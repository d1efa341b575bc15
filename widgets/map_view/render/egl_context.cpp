#include "widgets/map_view/render/egl_context.h"

#include <array>
#include <string>
#include <string_view>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

namespace leitstand {
namespace {

bool hasExtension(EGLDisplay display, std::string_view name) {
    const char* list = eglQueryString(display, EGL_EXTENSIONS);
    return list != nullptr && std::string_view(list).find(name) != std::string_view::npos;
}

/// Whether @p display starts and offers desktop OpenGL.
bool starts(EGLDisplay display) {
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE) return false;
    const char* interfaces = eglQueryString(display, EGL_CLIENT_APIS);
    if (interfaces == nullptr) return false;
    return (std::string(interfaces) + ' ').find("OpenGL ") != std::string::npos;  // OpenGL_ES is not enough
}

EGLDisplay firstDevice() {
    const auto queryDevices =
        reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    if (!hasExtension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") || queryDevices == nullptr) {
        return EGL_NO_DISPLAY;
    }
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (queryDevices(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_FALSE) count = 0;
    for (EGLint i = 0; i < count; ++i) {
        EGLDisplay display =
            eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(i)], nullptr);
        if (starts(display)) return display;
    }
    return EGL_NO_DISPLAY;
}

EGLDisplay surfaceless() {
    if (!hasExtension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) return EGL_NO_DISPLAY;
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    return starts(display) ? display : EGL_NO_DISPLAY;
}

EGLDisplay defaultDisplay() {
    EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    return starts(display) ? display : EGL_NO_DISPLAY;
}

Error eglError(std::string_view what) {
    return Error{fmt::format("{} (EGL error {:#06x})", what, eglGetError())};
}

}  // namespace

Result<std::unique_ptr<EglDisplay>> EglDisplay::open() {
    for (const auto& platform : {firstDevice, surfaceless, defaultDisplay}) {
        if (EGLDisplay display = platform(); display != EGL_NO_DISPLAY) {
            return std::unique_ptr<EglDisplay>(new EglDisplay(display));
        }
    }
    return eglError("EGL offers no display with OpenGL");
}

EglDisplay::~EglDisplay() {
    eglReleaseThread();
}

Result<std::unique_ptr<EglContext>> EglContext::create(const EglDisplay& display) {
    constexpr EGLint ConfigAttributes[] = {EGL_SURFACE_TYPE,
                                           EGL_PBUFFER_BIT,
                                           EGL_RENDERABLE_TYPE,
                                           EGL_OPENGL_BIT,
                                           EGL_RED_SIZE,
                                           8,
                                           EGL_GREEN_SIZE,
                                           8,
                                           EGL_BLUE_SIZE,
                                           8,
                                           EGL_NONE};
    constexpr EGLint ContextAttributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                            3,
                                            EGL_CONTEXT_MINOR_VERSION,
                                            2,
                                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                            EGL_NONE};
    constexpr EGLint SurfaceAttributes[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};

    EGLDisplay egl = display.m_display;
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) return eglError("EGL offers no desktop OpenGL");
    EGLConfig config = nullptr;
    EGLint configs = 0;
    if (eglChooseConfig(egl, ConfigAttributes, &config, 1, &configs) == EGL_FALSE || configs == 0) {
        return eglError("EGL has no configuration with 8 bits a colour");
    }
    EGLContext context = eglCreateContext(egl, config, EGL_NO_CONTEXT, ContextAttributes);
    if (context == EGL_NO_CONTEXT) return eglError("EGL cannot create an OpenGL 3.2 core context");
    EGLSurface surface = EGL_NO_SURFACE;
    if (!hasExtension(egl, "EGL_KHR_surfaceless_context")) {
        surface = eglCreatePbufferSurface(egl, config, SurfaceAttributes);
    }
    auto result = std::unique_ptr<EglContext>(new EglContext(egl, context, surface));
    if (eglMakeCurrent(egl, surface, surface, context) == EGL_FALSE) {
        return eglError("EGL cannot make its context current");
    }
    return result;
}

EglContext::~EglContext() {
    if (isCurrent()) eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (m_surface != EGL_NO_SURFACE) eglDestroySurface(m_display, m_surface);
    eglDestroyContext(m_display, m_context);
}

void EglContext::makeCurrent() const {
    if (!isCurrent()) eglMakeCurrent(m_display, m_surface, m_surface, m_context);
}

bool EglContext::isCurrent() const {
    return eglGetCurrentContext() == m_context;
}

}  // namespace leitstand
