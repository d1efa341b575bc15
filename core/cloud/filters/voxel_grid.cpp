#include "core/cloud/filters/voxel_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "core/base/mixed_bits.h"
#include "core/cloud/filters/cell_table.h"
#include "core/cloud/label_votes.h"

namespace leitstand {
namespace {

using detail::CellTable;

constexpr std::size_t PointsACell = 4;  ///< most clouds have at least so many; for others the tables grow
/// A scan has no more; tables for all of a dense cloud would not fit the processor's caches.
constexpr std::size_t MostReserved = 8'192;

/// Sums over the points of a cube.
struct Sum {
    Eigen::Vector3d points = Eigen::Vector3d::Zero();
    double count = 0.0;

    [[nodiscard]] Eigen::Vector3f centroid() const { return (points / count).cast<float>(); }
};

struct Cells {
    std::vector<std::uint32_t> ofPoints;  ///< CellTable::Outside: left out
    std::vector<Sum> sums;
    std::vector<Eigen::Vector3f> normals;  ///< their sums, by cube; empty: the points have none
};

Cells gathered(const std::vector<Eigen::Vector3f>& points, const std::vector<Eigen::Vector3f>& normals,
               double edge, const Eigen::Vector3d& origin) {
    Cells cells;
    cells.ofPoints.resize(points.size());
    const std::size_t expected = std::min(points.size() / PointsACell, MostReserved);
    cells.sums.reserve(expected);
    CellTable table(edge, expected, origin);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::uint32_t cell = table.cellOf(points[i]);
        cells.ofPoints[i] = cell;
        if (cell == CellTable::Outside) continue;
        if (cell == cells.sums.size()) cells.sums.emplace_back();
        Sum& sum = cells.sums[cell];
        sum.points += points[i].cast<double>();
        sum.count += 1.0;
        if (normals.empty()) continue;
        if (cell == cells.normals.size()) cells.normals.emplace_back(Eigen::Vector3f::Zero());
        cells.normals[cell] += normals[i];
    }
    return cells;
}

/// The real point that is nearest to its cube's centroid so far.
struct Nearest {
    Eigen::Vector3f centroid;
    float squaredDistance = std::numeric_limits<float>::infinity();
    std::uint32_t point = 0;
};

PointCloud nearestPoints(const PointCloud& cloud, const Cells& cells) {
    std::vector<Nearest> nearest(cells.sums.size());
    std::transform(cells.sums.begin(), cells.sums.end(), nearest.begin(),
                   [](const Sum& sum) { return Nearest{.centroid = sum.centroid()}; });
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
        if (cells.ofPoints[i] == CellTable::Outside) continue;
        Nearest& best = nearest[cells.ofPoints[i]];
        const float squaredDistance = (cloud.points[i] - best.centroid).squaredNorm();
        if (squaredDistance >= best.squaredDistance) continue;
        best.squaredDistance = squaredDistance;
        best.point = static_cast<std::uint32_t>(i);
    }
    PointCloud result;
    result.points.reserve(nearest.size());
    for (const Nearest& best : nearest) {
        result.points.push_back(cloud.points[best.point]);
        if (!cloud.normals.empty()) result.normals.push_back(cloud.normals[best.point]);
        if (!cloud.labels.empty()) result.labels.push_back(cloud.labels[best.point]);
    }
    return result;
}

std::vector<Label> commonestLabels(const PointCloud& cloud, const Cells& cells) {
    std::vector<LabelVotes> votes(cells.sums.size());
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
        if (cells.ofPoints[i] != CellTable::Outside) votes[cells.ofPoints[i]].add(cloud.labels[i]);
    }
    std::vector<Label> labels(votes.size());
    std::transform(votes.begin(), votes.end(), labels.begin(),
                   [](const LabelVotes& of) { return of.commonest(); });
    return labels;
}

}  // namespace

PointCloud voxelGrid(const PointCloud& cloud, double edge, VoxelPoint kept, const Eigen::Vector3d& origin) {
    if (!(edge > 0.0)) throw std::invalid_argument("voxelGrid: the edge of a voxel must be above 0");
    const bool centroids = kept == VoxelPoint::Centroid;
    const std::vector<Eigen::Vector3f> none;
    const Cells cells = gathered(cloud.points, centroids ? cloud.normals : none, edge, origin);
    if (!centroids) return nearestPoints(cloud, cells);
    PointCloud result;
    result.points.resize(cells.sums.size());
    std::transform(cells.sums.begin(), cells.sums.end(), result.points.begin(),
                   [](const Sum& sum) { return sum.centroid(); });
    if (!cloud.normals.empty()) {
        result.normals = cells.normals;
        for (Eigen::Vector3f& normal : result.normals) normal.normalize();  // a zero stays zero
    }
    if (!cloud.labels.empty()) result.labels = commonestLabels(cloud, cells);
    return result;
}

Eigen::Vector3d ownGridOrigin(std::span<const Eigen::Vector3f> points, double edge) {
    constexpr std::size_t Enough = 16;  // points: noise makes those of each scan differ
    std::uint64_t bits = 0;
    std::size_t taken = 0;
    for (const Eigen::Vector3f& point : points) {
        if (!point.allFinite()) continue;
        for (const float coordinate : point)
            bits = mixedBits(bits ^ std::bit_cast<std::uint32_t>(coordinate));
        if (++taken == Enough) break;
    }
    Eigen::Vector3d origin;
    for (double& coordinate : origin) {
        bits = mixedBits(bits);
        coordinate = edge * std::ldexp(static_cast<double>(bits >> 11), -53);
    }
    return origin;
}

}  // namespace leitstand
