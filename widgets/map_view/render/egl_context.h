#pragma once

#include <memory>

#include "core/base/result.h"

namespace leitstand {

/// A connection to EGL that needs no window system: the first device that works, then Mesa's surfaceless
/// platform, then the default display. One thread.
class EglDisplay {
public:
    [[nodiscard]] static Result<std::unique_ptr<EglDisplay>> open();
    ~EglDisplay();
    EglDisplay(const EglDisplay&) = delete;
    EglDisplay& operator=(const EglDisplay&) = delete;

private:
    friend class EglContext;
    EglDisplay(void* display, bool ours) : m_display(display), m_ours(ours) {}

    void* m_display;
    bool m_ours;  ///< false for the default display, which the window system's plugin may use too
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
    void* m_surface;  ///< a tiny one where the driver cannot do without, else none
};

}  // namespace leitstand
