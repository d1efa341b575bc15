#include <vtk_glew.h>
// glew must come before every other header that includes OpenGL.
#include "widgets/map_view/render/range_mapper.h"

#include <cstddef>

#include <vtkMath.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLHelper.h>
#include <vtkOpenGLIndexBufferObject.h>
#include <vtkPolyData.h>

namespace leitstand {

vtkStandardNewMacro(RangeMapper)

    void RangeMapper::setRange(double from, double to) {
    m_from = from;
    m_to = to;
}

void RangeMapper::ComputeBounds() {
    vtkMath::UninitializeBounds(Bounds);
    if (vtkPolyData* const data = GetInput(); data != nullptr && data->GetPoints() != nullptr)
        data->GetPoints()->GetBounds(Bounds);
}

// VTK's own needs a cell for the points, and an index of four bytes per point in memory and in OpenGL.
void RangeMapper::BuildIBO(vtkRenderer* /*renderer*/, vtkActor* /*actor*/, vtkPolyData* data) {
    Primitives[PrimitivePoints].IBO->IndexCount = static_cast<std::size_t>(data->GetNumberOfPoints());
}

void RangeMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) {
    vtkOpenGLHelper& points = Primitives[PrimitivePoints];
    const auto count = static_cast<double>(points.IBO->IndexCount);
    const auto first = static_cast<GLint>(m_from * count);
    const auto last = static_cast<GLint>(m_to * count);
    if (last <= first) return;
    UpdateShaders(points, renderer, actor);
    glDrawArrays(GL_POINTS, first, last - first);
}

}  // namespace leitstand
