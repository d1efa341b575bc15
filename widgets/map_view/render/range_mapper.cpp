#include <vtk_glew.h>
// glew comes before every other header that knows OpenGL.
#include "widgets/map_view/render/range_mapper.h"

#include <cstddef>

#include <vtkObjectFactory.h>
#include <vtkOpenGLHelper.h>
#include <vtkOpenGLIndexBufferObject.h>

namespace leitstand {

vtkStandardNewMacro(RangeMapper)

    void RangeMapper::setRange(double from, double to) {
    m_from = from;
    m_to = to;
}

void RangeMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) {
    vtkOpenGLHelper& points = Primitives[PrimitivePoints];
    const auto count = static_cast<double>(points.IBO->IndexCount);
    const auto first = static_cast<std::size_t>(m_from * count);
    const auto last = static_cast<std::size_t>(m_to * count);
    if (last <= first) return;
    UpdateShaders(points, renderer, actor);
    points.IBO->Bind();
    const auto* offset = reinterpret_cast<const void*>(first * sizeof(unsigned int));
    glDrawElements(GL_POINTS, static_cast<GLsizei>(last - first), GL_UNSIGNED_INT, offset);
    points.IBO->Release();
}

}  // namespace leitstand
