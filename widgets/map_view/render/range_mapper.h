#pragma once

#include <vtkOpenGLPolyDataMapper.h>

namespace leitstand {

/// Draws a range of the points of a poly data, in their order, without cells. Since that order is random, any
/// range is a fair sample; consecutive ranges add up to the whole. Render thread only.
class RangeMapper final : public vtkOpenGLPolyDataMapper {
public:
    static RangeMapper* New();
    vtkTypeMacro(RangeMapper, vtkOpenGLPolyDataMapper);

    /// Sets the range of points drawn next, as fractions of their number.
    void setRange(double from, double to);

protected:
    void ComputeBounds() override;  ///< of all points
    void BuildIBO(vtkRenderer* renderer, vtkActor* actor, vtkPolyData* data) override;
    void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;

private:
    double m_from = 0.0, m_to = 1.0;
};

}  // namespace leitstand
