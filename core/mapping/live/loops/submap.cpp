#include "core/mapping/live/loops/submap.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/cloud/filters/voxel_grid.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/storeys.h"
#include "core/registration/icp.h"

namespace leitstand {
namespace {

constexpr double RestEdge = 0.10, SubmapEdge = 0.15;  ///< of the cubes that keep one point [m]
constexpr std::size_t MostLooked = 6'000;             ///< points of the submap, while it is dragged
constexpr std::size_t MostSnapped = 40'000;           ///< ... and when it is snapped

/// Returns evenly picked points of @p cloud, at most @p most.
PointCloud thinned(const PointCloud& cloud, std::size_t most) {
    const std::size_t step = (cloud.points.size() + most - 1) / std::max<std::size_t>(1, most);
    if (step <= 1) return cloud;
    PointCloud kept;
    for (std::size_t i = 0; i < cloud.points.size(); i += step) {
        kept.points.push_back(cloud.points[i]);
        if (i < cloud.normals.size()) kept.normals.push_back(cloud.normals[i]);
        if (i < cloud.labels.size()) kept.labels.push_back(cloud.labels[i]);
    }
    return kept;
}

/// Adds the points of @p scan for matching, in the map relative to @p origin.
void append(PointCloud& cloud, const LiveKeyScan& scan, const Eigen::Vector3d& origin) {
    if (!scan.reduced) return;
    const PointCloud own = scan.reduced->unpacked();
    const Pose& pose = scan.pose.scanInMap;
    for (std::size_t i = 0; i < own.points.size(); ++i) {
        cloud.points.emplace_back((pose * own.points[i].cast<double>() - origin).cast<float>());
        cloud.normals.emplace_back(
            i < own.normals.size()
                ? Eigen::Vector3f((pose.linear() * own.normals[i].cast<double>()).cast<float>())
                : Eigen::Vector3f(Eigen::Vector3f::Zero()));
        cloud.labels.push_back(i < own.labels.size() ? own.labels[i] : Label::Unlabelled);
    }
}

/// Collects points of many scans and thins them on the way: the sum of all would take too much memory.
class Gathered {
public:
    explicit Gathered(double edge) : m_edge(edge) {}
    void add(const LiveKeyScan& scan, const Eigen::Vector3d& origin) {
        append(m_cloud, scan, origin);
        if (m_cloud.points.size() < m_thinAt) return;
        m_cloud = voxelGrid(m_cloud, m_edge);
        m_thinAt = 2 * m_cloud.points.size() + Step;
    }
    [[nodiscard]] PointCloud take() { return voxelGrid(std::exchange(m_cloud, {}), m_edge); }

private:
    static constexpr std::size_t Step = 200'000;
    double m_edge;
    PointCloud m_cloud;
    std::size_t m_thinAt = Step;
};

}  // namespace

std::set<std::uint64_t> submapOf(const LiveMap& map, std::uint64_t id, SubmapKind kind) {
    const auto chosen = std::find_if(map.scans.begin(), map.scans.end(),
                                     [id](const LiveKeyScan& scan) { return scan.id == id; });
    if (chosen == map.scans.end() || !chosen->counts()) return {};
    std::vector<StoreyShare> storeys;
    if (kind == SubmapKind::Storey) {
        std::vector<ReportScan> scans;
        for (const LiveKeyScan& scan : map.scans) {
            if (scan.counts() && scan.part == chosen->part)
                scans.push_back({.scan = scan.scan, .scanInMap = scan.pose.scanInMap});
        }
        storeys = sharesOf(storeysOf(scans));
    }
    const auto storeyOf = [&](const LiveKeyScan& scan) {
        const Pose base = scan.pose.scanInMap * scan.sensorInBase.inverse();
        return shareAt(storeys, base.translation().z());
    };
    const std::size_t chosenStorey = kind == SubmapKind::Storey ? storeyOf(*chosen) : 0;
    std::set<std::uint64_t> submap;
    std::size_t counting = 0;
    for (const LiveKeyScan& scan : map.scans) {
        if (!scan.counts()) continue;
        ++counting;
        const bool samePart = scan.part == chosen->part, sameRobot = scan.scan->robot == chosen->scan->robot;
        const bool moves = kind == SubmapKind::FromHere
                               ? samePart && sameRobot && scan.entered >= chosen->entered
                           : kind == SubmapKind::Robot  ? samePart && sameRobot
                           : kind == SubmapKind::Storey ? samePart && storeyOf(scan) == chosenStorey
                           : kind == SubmapKind::Scan   ? scan.id == id
                                                        : samePart;
        if (moves) submap.insert(scan.id);
    }
    return submap.size() < counting ? submap : std::set<std::uint64_t>{};
}

std::set<std::uint64_t> leftBehind(const LiveMap& map, std::uint64_t id, SubmapKind kind) {
    if (kind != SubmapKind::Scan) return {};
    const double most = LoopSettings().sameAge;
    std::vector<const LiveKeyScan*> scans;  // of that robot
    const auto chosen = std::find_if(map.scans.begin(), map.scans.end(),
                                     [id](const LiveKeyScan& scan) { return scan.id == id; });
    if (chosen == map.scans.end()) return {};
    std::size_t at = 0;
    for (const LiveKeyScan& scan : map.scans) {
        if (!scan.counts() || scan.scan->robot != chosen->scan->robot || scan.part != chosen->part) continue;
        if (scan.id == id) at = scans.size();
        scans.push_back(&scan);
    }
    std::set<std::uint64_t> near;
    const auto go = [&](std::ptrdiff_t step) {
        double way = 0.0;
        for (auto i = static_cast<std::ptrdiff_t>(at) + step; i >= 0 && i < std::ssize(scans); i += step) {
            const LiveKeyScan& one = *scans[static_cast<std::size_t>(i)];
            way += distanceBetween(scans[static_cast<std::size_t>(i - step)]->pose.scanInMap,
                                   one.pose.scanInMap);
            if (way > most) return;
            near.insert(one.id);
        }
    };
    go(-1);
    go(1);
    return near;
}

SubmapOnMap::SubmapOnMap(LiveMapPtr map, std::set<std::uint64_t> submap, const std::set<std::uint64_t>& left,
                         const Progress& progress)
    : m_map(std::move(map)), m_submap(std::move(submap)) {
    std::size_t count = 0;
    for (const LiveKeyScan& scan : m_map->scans) {
        if (!m_submap.contains(scan.id) || !scan.counts()) continue;
        m_middle += scan.pose.scanInMap.translation();
        ++count;
    }
    if (count == 0) return;
    m_middle /= static_cast<double>(count);
    Gathered moving(SubmapEdge), rest(RestEdge);
    for (const LiveKeyScan& scan : m_map->scans) {
        if (progress.cancelled()) return;
        if (!scan.counts()) continue;
        if (m_submap.contains(scan.id))
            moving.add(scan, m_middle);
        else if (!left.contains(scan.id))
            rest.add(scan, Eigen::Vector3d::Zero());
    }
    m_cloud = thinned(moving.take(), MostSnapped);
    m_rest = rest.take();
    if (!m_rest.points.empty()) m_search = makeSearch(m_rest, SearchMethod::KdTree);
}

SubmapFit SubmapOnMap::at(const Pose& moved) const {
    SubmapFit fit;
    if (!m_search || m_cloud.points.empty()) return fit;
    const Pose place = moved * Eigen::Translation3d(m_middle);
    const std::size_t step = std::max<std::size_t>(1, m_cloud.points.size() / MostLooked);
    std::size_t looked = 0, near = 0;
    double squares = 0.0;
    for (std::size_t i = 0; i < m_cloud.points.size(); i += step) {
        const Eigen::Vector3f point = (place * m_cloud.points[i].cast<double>()).cast<float>();
        if (!point.allFinite()) continue;
        ++looked;
        const Neighbour nearest =
            m_search->nearest(point, Label::Unlabelled, static_cast<float>(Near * Near));
        if (!nearest.found()) continue;
        ++near;
        squares += static_cast<double>(nearest.squaredDistance);
    }
    if (near == 0) return fit;
    fit.overlap = static_cast<double>(near) / static_cast<double>(looked);
    fit.seam = std::sqrt(squares / static_cast<double>(near));
    return fit;
}

std::optional<Pose> SubmapOnMap::snapped(const Pose& moved, const Progress& progress) const {
    if (!m_search || at(moved).overlap < LeastOverlap) return std::nullopt;
    IcpSettings settings;
    settings.maxDistances = {1.0, 0.5, 0.25};
    settings.facing = true;
    settings.threads = 1;
    settings.maxIterations = 120;
    const Pose guess = moved * Eigen::Translation3d(m_middle);
    const IcpResult found = align(m_rest, *m_search, m_cloud, guess, settings, progress);
    const Pose pose = found.pose * Eigen::Translation3d(-m_middle);
    if (progress.cancelled() || !pose.matrix().allFinite() || at(pose).overlap < LeastOverlap)
        return std::nullopt;
    return pose;
}

std::map<std::uint64_t, Pose> SubmapOnMap::places(const Pose& moved) const {
    std::map<std::uint64_t, Pose> places;
    for (const LiveKeyScan& scan : m_map->scans) {
        if (m_submap.contains(scan.id)) places.emplace(scan.id, moved * scan.pose.scanInMap);
    }
    return places;
}

}  // namespace leitstand
