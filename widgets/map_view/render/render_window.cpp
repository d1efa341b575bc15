#include <vtk_glew.h>
// glew must come before every other header that includes OpenGL.
#include "widgets/map_view/render/render_window.h"

#include <algorithm>
#include <cstddef>

#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>

#include "widgets/map_view/render/egl_context.h"

namespace leitstand {

vtkStandardNewMacro(RenderWindow)

    void RenderWindow::start(const EglContext& context) {
    m_context = &context;
    SetOwnContext(0);
    SetFrameBlitModeToNoBlit();
    SetMultiSamples(0);
    SetReadyForRendering(true);
}

QImage RenderWindow::read() {
    vtkOpenGLFramebufferObject* frame = GetDisplayFramebuffer();
    int width = 0, height = 0;
    if (frame != nullptr) frame->GetLastSize(width, height);
    if (width <= 0 || height <= 0) return {};
    QImage image(width, height, QImage::Format_RGB32);
    GetState()->PushReadFramebufferBinding();
    frame->Bind(GL_READ_FRAMEBUFFER);
    frame->ActivateReadBuffer(0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, image.bits());
    GetState()->PopReadFramebufferBinding();
    for (int row = 0; row < height / 2; ++row) {  // OpenGL's first row is the lowest
        auto* upper = reinterpret_cast<QRgb*>(image.scanLine(row));
        std::swap_ranges(upper, upper + width, reinterpret_cast<QRgb*>(image.scanLine(height - 1 - row)));
    }
    return image;
}

void RenderWindow::MakeCurrent() {
    if (m_context != nullptr) m_context->makeCurrent();
}

bool RenderWindow::IsCurrent() {
    return m_context != nullptr && m_context->isCurrent();
}

void RenderWindow::OpenGLInitContext() {
    ContextCreationTime.Modified();
    if (Initialized) return;
    // Under EGL, glew reports "no GLX display" although every entry point is loaded, and VTK would fail.
    constexpr GLenum NoGlxDisplay = 4;
    glewExperimental = GL_TRUE;
    const GLenum answer = glewInit();
    GlewInitValid = (answer == GLEW_OK || answer == NoGlxDisplay) && GLEW_VERSION_3_2;
    Initialized = GlewInitValid;
}

int RenderWindow::GetColorBufferSizes(int* rgba) {
    std::fill_n(rgba, 4, 8);  // there is no default framebuffer to query
    return 32;
}

}  // namespace leitstand
