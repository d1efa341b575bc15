#pragma once

#include <QImage>

#include <vtkGenericOpenGLRenderWindow.h>

namespace leitstand {

class EglContext;

/// An offscreen VTK window: draws in an EGL context and reads the result back. Render thread only.
class RenderWindow final : public vtkGenericOpenGLRenderWindow {
public:
    static RenderWindow* New();
    vtkTypeMacro(RenderWindow, vtkGenericOpenGLRenderWindow);

    /// Draws in @p context, which must outlive this window.
    void start(const EglContext& context);
    /// Whether the context offers what VTK needs.
    [[nodiscard]] bool ready() const { return Initialized; }
    /// Returns the last frame, opaque; null if nothing was drawn.
    [[nodiscard]] QImage read();

    void MakeCurrent() override;
    bool IsCurrent() override;
    void OpenGLInitContext() override;
    int GetColorBufferSizes(int* rgba) override;

private:
    const EglContext* m_context = nullptr;
};

}  // namespace leitstand
