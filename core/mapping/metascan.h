#pragma once

#include "core/base/pose.h"
#include "core/cloud/scan.h"

namespace leitstand {

/// All scans so far as one cloud in the map's frame, thinned to one point a voxel, so that ground seen twice
/// is not held twice.
class Metascan {
public:
    /// @p voxel: edge of the grid [m].
    explicit Metascan(double voxel) : m_voxel(voxel) {}

    void add(const PointCloud& cloud, const Pose& cloudInMap);
    [[nodiscard]] const PointCloud& cloud() const { return m_cloud; }

private:
    double m_voxel;
    PointCloud m_cloud;
};

}  // namespace leitstand
