#pragma once

#include <memory>

#include "core/base/result.h"

namespace leitstand {

/// A connection to EGL without a window system. Tries the first device that works, then Mesa's surfaceless
/// platform, then the default display. One thread. EGL has one connection per process and platform. It stays
/// open until the process ends, since others may use it and drivers leak memory when it closes.
class EglDisplay {
public:
    [[nodiscard]] static Result<std::unique_ptr<EglDisplay>> open();
    ~EglDisplay();
    EglDisplay(const EglDisplay&) = delete;
    EglDisplay& operator=(const EglDisplay&) = delete;

private:
    friend class EglContext;
    explicit EglDisplay(void* display) : m_display(display) {}

    void* m_display;
};

/// An OpenGL 3.2 core context without a window. One thread; must not outlive its display.
class EglContext {
public:
    [[nodiscard]] static Result<std::unique_ptr<EglContext>> create(const EglDisplay& display);
    ~EglContext();
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    void makeCurrent() const;
    [[nodiscard]] bool isCurrent() const;

private:
    EglContext(void* display, void* context, void* surface)
        : m_display(display), m_context(context), m_surface(surface) {}

    void* m_display;
    void* m_context;
    void* m_surface;  ///< 1 x 1 px if the driver needs a surface, otherwise none
};

}  // namespace leitstand
