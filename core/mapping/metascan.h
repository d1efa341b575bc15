#pragma once

#include <memory>

#include "core/base/pose.h"
#include "core/cloud/filters/cell_table.h"
#include "core/cloud/scan.h"
#include "core/cloud/search/search.h"

namespace leitstand {

/// Settings of a metascan.
struct MetascanSettings {
    double voxel = 0.1;  ///< edge of the grid [m]
    SearchMethod search = SearchMethod::KdTree;
    double epsilon = 0.0;  ///< argument of makeSearch()
};

/// All scans so far as one cloud in the map's frame, thinned to one point per voxel. So ground that is seen
/// twice is not stored twice. The newest points are indexed again with each scan, and until then a voxel has
/// the mean of its points. Older points never change, since later scans were registered to them.
class Metascan {
public:
    explicit Metascan(const MetascanSettings& settings);
    ~Metascan();

    /// Adds @p cloud at its pose in the map. Either all clouds have normals or none has; the same is required
    /// of labels.
    void add(const PointCloud& cloud, const Pose& cloudInMap);
    [[nodiscard]] const PointCloud& cloud() const { return m_cloud; }
    /// Returns the search in cloud(), valid until the next add().
    [[nodiscard]] const Search& search() const;

private:
    class Parts;

    /// Sums over the points in a voxel.
    struct Sum {
        Eigen::Vector3d points = Eigen::Vector3d::Zero();
        Eigen::Vector3f normals = Eigen::Vector3f::Zero();
        double count = 0.0;
    };
    detail::CellTable m_cells;
    std::vector<Sum> m_sums;
    PointCloud m_cloud;
    std::unique_ptr<Parts> m_parts;
};

}  // namespace leitstand
