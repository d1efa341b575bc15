#pragma once

#include <memory>
#include <vector>

#include <vtkSmartPointer.h>

#include "widgets/map_view/scene/scene_content.h"

class vtkActor;
class vtkMapper;
class vtkPlaneCollection;

namespace leitstand {

class RangeMapper;

/// A scan's points in VTK. Points and colours stay where they are; only their pose changes. Render thread
/// only.
class ScanActor {
public:
    ScanActor();
    ~ScanActor();
    ScanActor(ScanActor&&) noexcept = default;
    ScanActor& operator=(ScanActor&&) noexcept = default;

    /// Shows @p scan from now on; what has not changed costs nothing.
    void update(const SceneScan& scan);
    void setClip(vtkPlaneCollection* planesInMap);
    void setPointSize(double devicePixels);
    /// The share of the points drawn next, as fractions.
    void setRange(double from, double to);

    [[nodiscard]] vtkActor* actor() const { return m_actor; }
    [[nodiscard]] std::size_t shownPoints() const;

private:
    void rebuild();

    ScanPointsPtr m_points;  ///< these three own the memory that VTK draws from
    PointCloudLook m_look;
    bool m_visible = false;
    vtkSmartPointer<RangeMapper> m_mapper;
    vtkSmartPointer<vtkActor> m_actor;
};

/// The voxels in VTK. Render thread only.
class VoxelActor {
public:
    VoxelActor();
    ~VoxelActor();

    /// Shows @p mesh from now on, or nothing.
    void update(std::shared_ptr<const VoxelMesh> mesh);

    [[nodiscard]] vtkActor* actor() const { return m_actor; }

private:
    std::shared_ptr<const VoxelMesh> m_mesh;  ///< owns the memory that VTK draws from
    vtkSmartPointer<vtkActor> m_actor;
};

}  // namespace leitstand
