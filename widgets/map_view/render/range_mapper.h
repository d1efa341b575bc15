#pragma once

#include <vtkOpenGLPolyDataMapper.h>

namespace leitstand {

/// Draws a range of the points in a poly data, in their order, without cells. The order is random, so any
/// range is a fair sample; consecutive ranges give the whole. Render thread only.
class RangeMapper final : public vtkOpenGLPolyDataMapper {
public:
    static RangeMapper* New();
    vtkTypeMacro(RangeMapper, vtkOpenGLPolyDataMapper);

    /// Sets which points are drawn next, as fractions of their number.
    void setRange(double from, double to);

protected:
    void ComputeBounds() override;  ///< sets the bounds of all points
    void BuildIBO(vtkRenderer* renderer, vtkActor* actor, vtkPolyData* data) override;
    void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;

private:
    double m_from = 0.0, m_to = 1.0;
};

}  // namespace leitstand
