#include "core/mapping/live/map/local_map.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/cloud/filters/voxel_grid.h"

namespace leitstand {
namespace {

void append(PointCloud& cloud, const PointCloud& more, const Pose& moreInCloud) {
    const Eigen::Isometry3f motion = moreInCloud.cast<float>();
    for (const Eigen::Vector3f& point : more.points) cloud.points.push_back(motion * point);
    for (const Eigen::Vector3f& normal : more.normals) cloud.normals.push_back(motion.linear() * normal);
}

}  // namespace

double mapDistance(const Pose& a, const Pose& b) {
    constexpr double Storeys = 4.0;
    const Eigen::Vector3d between = a.translation() - b.translation();
    return std::hypot(between.head<2>().norm(), Storeys * between.z());
}

std::uint64_t partAt(std::span<const LiveKeyScan> scans, const Pose& place) {
    const LiveKeyScan* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const LiveKeyScan& scan : scans) {
        const double distance = mapDistance(scan.pose.scanInMap, place);
        if (!scan.counts() || distance >= least) continue;
        least = distance;
        nearest = &scan;
    }
    return nearest != nullptr ? nearest->part : 0;
}

std::vector<LiveKeyScan> ofPart(std::span<const LiveKeyScan> scans, std::uint64_t part) {
    std::vector<LiveKeyScan> found;
    std::copy_if(scans.begin(), scans.end(), std::back_inserter(found),
                 [part](const LiveKeyScan& scan) { return scan.part == part; });
    return found;
}

LocalMap localMap(std::span<const LiveKeyScan> scans, const Pose& place, const LocalMapSettings& settings) {
    struct Candidate {
        double distance;
        const LiveKeyScan* scan;
    };
    std::vector<Candidate> candidates;
    for (const LiveKeyScan& scan : scans) {
        if (scan.counts()) candidates.push_back({mapDistance(scan.pose.scanInMap, place), &scan});
    }
    const auto most = std::min(candidates.size(), static_cast<std::size_t>(std::max(1, settings.scans)));
    std::partial_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(most),
                      candidates.end(), [](const Candidate& a, const Candidate& b) {
                          return a.distance != b.distance ? a.distance < b.distance : a.scan->id > b.scan->id;
                      });
    candidates.resize(most);
    LocalMap local;
    PointCloud all;
    std::size_t points = 0;
    for (const Candidate& candidate : candidates) points += candidate.scan->reduced->size().value_or(0);
    all.points.reserve(points);
    all.normals.reserve(points);
    for (const Candidate& candidate : candidates) {
        local.scans.push_back(candidate.scan->id);
        append(all, candidate.scan->reduced->unpacked(), candidate.scan->pose.scanInMap);
    }
    if (all.points.empty()) return local;
    local.cloud = voxelGrid(all, settings.voxel, VoxelPoint::Centroid);
    local.search = makeSearch(local.cloud, SearchMethod::KdTree);
    return local;
}

}  // namespace leitstand
