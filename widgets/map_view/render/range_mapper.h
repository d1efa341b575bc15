#pragma once

#include <memory>

#include <vtkOpenGLPolyDataMapper.h>

#include "widgets/map_view/scene/point_order.h"

namespace leitstand {

/// Draws points of a poly data, which needs no cells, in an order of its own: since that is random, any range
/// of it is a fair sample, and ranges drawn one after another add up to the whole. Render thread only.
class RangeMapper final : public vtkOpenGLPolyDataMapper {
public:
    static RangeMapper* New();
    vtkTypeMacro(RangeMapper, vtkOpenGLPolyDataMapper);

    /// Which points of the next input are drawn.
    void setOrder(std::shared_ptr<const PointOrder> order);
    /// The share of the points drawn next, as fractions of their number.
    void setRange(double from, double to);

    void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
    void ComputeBounds() override;  ///< of all points
    void BuildIBO(vtkRenderer* renderer, vtkActor* actor, vtkPolyData* data) override;
    void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;

private:
    std::shared_ptr<const PointOrder> m_order, m_uploaded;
    double m_from = 0.0, m_to = 1.0;
};

}  // namespace leitstand
