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
    double epsilon = 0.0;  ///< makeSearch()
};

/// All scans so far as one cloud in the map's frame, thinned to one point a voxel, so that ground seen twice
/// is not held twice. Recent points are indexed again with each scan, and a voxel keeps the mean of its
/// points so long. The rest stays as it is, since later scans were registered to it.
class Metascan {
public:
    explicit Metascan(const MetascanSettings& settings);
    ~Metascan();

    /// All clouds have normals and labels, or none has.
    void add(const PointCloud& cloud, const Pose& cloudInMap);
    [[nodiscard]] const PointCloud& cloud() const { return m_cloud; }
    /// Returns the search over cloud(), valid until the next add().
    [[nodiscard]] const Search& search() const;

private:
    class Parts;

    /// The sums of a voxel's points.
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
