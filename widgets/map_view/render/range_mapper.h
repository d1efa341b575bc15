#pragma once

#include <Eigen/Geometry>

#include <vtkOpenGLPolyDataMapper.h>

namespace leitstand {

/// Draws a range of a poly data's vertices: since points are shuffled, any range is a fair sample, and
/// ranges drawn one after another add up to the whole. Render thread only.
class RangeMapper final : public vtkOpenGLPolyDataMapper {
public:
    static RangeMapper* New();
    vtkTypeMacro(RangeMapper, vtkOpenGLPolyDataMapper);

    /// The share of the points drawn next, as fractions of their number.
    void setRange(double from, double to);
    /// Of what is drawn: VTK would lay out a list of all points to find it, and keep the list.
    void setBounds(const Eigen::AlignedBox3d& bounds) { m_bounds = bounds; }

protected:
    void ComputeBounds() override;
    void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;

private:
    double m_from = 0.0, m_to = 1.0;
    Eigen::AlignedBox3d m_bounds;
};

}  // namespace leitstand
