#pragma once

#include <QImage>

#include <vtkGenericOpenGLRenderWindow.h>

namespace leitstand {

class EglContext;

/// VTK's window without a window: draws in an EGL context and is read back. Render thread only.
class RenderWindow final : public vtkGenericOpenGLRenderWindow {
public:
    static RenderWindow* New();
    vtkTypeMacro(RenderWindow, vtkGenericOpenGLRenderWindow);

    /// Draws in @p context from now on, which must outlive this window.
    void start(const EglContext& context);
    /// Whether the context offers what VTK needs.
    [[nodiscard]] bool ready() const { return Initialized; }
    /// What was drawn last, opaque; null when nothing was.
    [[nodiscard]] QImage read();

    void MakeCurrent() override;
    bool IsCurrent() override;
    void OpenGLInitContext() override;
    int GetColorBufferSizes(int* rgba) override;

private:
    const EglContext* m_context = nullptr;
};

}  // namespace leitstand
