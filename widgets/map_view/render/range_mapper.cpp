#include <vtk_glew.h>
// glew comes before every other header that knows OpenGL.
#include "widgets/map_view/render/range_mapper.h"

#include <cstddef>
#include <cstdint>
#include <utility>

#include <vtkMath.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLHelper.h>
#include <vtkOpenGLIndexBufferObject.h>
#include <vtkPolyData.h>

namespace leitstand {

vtkStandardNewMacro(RangeMapper)

    void RangeMapper::setOrder(std::shared_ptr<const PointOrder> order) {
    if (order == m_order) return;
    m_order = std::move(order);
    Modified();
}

void RangeMapper::setRange(double from, double to) {
    m_from = from;
    m_to = to;
}

void RangeMapper::ReleaseGraphicsResources(vtkWindow* window) {
    m_uploaded.reset();
    Superclass::ReleaseGraphicsResources(window);
}

void RangeMapper::ComputeBounds() {
    vtkMath::UninitializeBounds(Bounds);
    if (vtkPolyData* const data = GetInput(); data != nullptr && data->GetPoints() != nullptr)
        data->GetPoints()->GetBounds(Bounds);
}

// VTK's own would need a cell for points, and four bytes for each in memory and where it is drawn.
void RangeMapper::BuildIBO(vtkRenderer* /*renderer*/, vtkActor* /*actor*/, vtkPolyData* /*data*/) {
    if (m_uploaded == m_order) return;
    m_uploaded = m_order;
    vtkOpenGLIndexBufferObject& places = *Primitives[PrimitivePoints].IBO;
    places.IndexCount = m_order ? m_order->size() : 0;
    if (places.IndexCount == 0) return;
    constexpr auto Kind = vtkOpenGLBufferObject::ElementArrayBuffer;
    if (m_order->wide().empty())
        places.Upload(m_order->narrow(), Kind);
    else
        places.Upload(m_order->wide(), Kind);
}

void RangeMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) {
    vtkOpenGLHelper& points = Primitives[PrimitivePoints];
    const auto count = static_cast<double>(points.IBO->IndexCount);
    const auto first = static_cast<std::size_t>(m_from * count);
    const auto last = static_cast<std::size_t>(m_to * count);
    if (last <= first || !m_uploaded) return;
    UpdateShaders(points, renderer, actor);
    points.IBO->Bind();
    const bool narrow = m_uploaded->wide().empty();
    const std::size_t each = narrow ? sizeof(std::uint16_t) : sizeof(std::uint32_t);
    glDrawElements(GL_POINTS, static_cast<GLsizei>(last - first),
                   narrow ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT, reinterpret_cast<const void*>(first * each));
    points.IBO->Release();
}

}  // namespace leitstand
