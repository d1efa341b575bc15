#pragma once

#include <vtkOpenGLPolyDataMapper.h>

namespace leitstand {

/// Draws points of a poly data, which needs no cells, in the order in which they lie there: since that is
/// random, any range of it is a fair sample, and ranges drawn one after another add up to the whole. Render
/// thread only.
class RangeMapper final : public vtkOpenGLPolyDataMapper {
public:
    static RangeMapper* New();
    vtkTypeMacro(RangeMapper, vtkOpenGLPolyDataMapper);

    /// The share of the points drawn next, as fractions of their number.
    void setRange(double from, double to);

protected:
    void ComputeBounds() override;  ///< of all points
    void BuildIBO(vtkRenderer* renderer, vtkActor* actor, vtkPolyData* data) override;
    void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;

private:
    double m_from = 0.0, m_to = 1.0;
};

}  // namespace leitstand
