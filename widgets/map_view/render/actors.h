#pragma once

#include <cstddef>
#include <memory>

#include <vtkSmartPointer.h>

#include "widgets/map_view/scene/points/drawn_points.h"

class vtkActor;
class vtkMapper;
class vtkPlaneCollection;

namespace leitstand {

class RangeMapper;

/// Draws points with VTK. If only the pose changes, the points are not uploaded again. Render thread only.
class PointsActor {
public:
    PointsActor();
    ~PointsActor();
    PointsActor(PointsActor&&) noexcept = default;
    PointsActor& operator=(PointsActor&&) noexcept = default;

    /// Shows @p points; null: nothing. Setting the same points again costs nothing.
    void update(DrawnPointsPtr points);
    void setPose(const Pose& poseInMap);
    void setVisible(bool visible);
    void setClip(vtkPlaneCollection* planesInMap);
    void setPointSize(double devicePixels);
    /// Sets which points are drawn next, as fractions of their number.
    void setRange(double from, double to);

    [[nodiscard]] vtkActor* actor() const { return m_actor; }
    [[nodiscard]] std::size_t shownPoints() const { return m_points ? m_points->size() : 0; }

private:
    DrawnPointsPtr m_points;  ///< owns the memory that VTK draws from
    vtkSmartPointer<RangeMapper> m_mapper;
    vtkSmartPointer<vtkActor> m_actor;
};

/// Draws a scan's points with VTK. Render thread only.
class ScanActor {
public:
    /// Shows @p scan; isShown() must be true for it. Setting the same points in the same look costs nothing.
    void update(const SceneScan& scan);
    [[nodiscard]] PointsActor& points() { return m_points; }

private:
    ScanPointsPtr m_scan;   ///< points that are in m_points
    PointCloudLook m_look;  ///< look of m_points
    PointsActor m_points;
};

/// Draws voxels with VTK. Render thread only.
class VoxelActor {
public:
    VoxelActor();
    ~VoxelActor();

    /// Shows @p mesh, or nothing when null.
    void update(std::shared_ptr<const VoxelMesh> mesh);

    [[nodiscard]] vtkActor* actor() const { return m_actor; }

private:
    std::shared_ptr<const VoxelMesh> m_mesh;  ///< owns the memory that VTK draws from
    vtkSmartPointer<vtkActor> m_actor;
};

}  // namespace leitstand
