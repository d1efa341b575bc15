#include "core/handin/map/robot_path.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "core/base/time.h"
#include "core/mapping/live/trail.h"

namespace leitstand {
namespace {

constexpr double MostDisagreement = 1.0;  ///< of two anchors; beyond it the odometry was reset [m]
constexpr double Turned = degrees(10);
constexpr std::chrono::seconds Beyond{1};  ///< after the end of odometry, an anchor alone places the robot

/// The odometry frame in the map, by an anchor.
struct OdometryInMap {
    Time time{};
    Pose odomInMap = Pose::Identity();
};

/// Returns the odometry at @p time, interpolated; empty when it is unknown within half a second.
std::optional<Pose> odometryAt(std::span<const PathPose> odometry, Time time) {
    constexpr auto Gap = std::chrono::milliseconds(500);
    const auto after = std::lower_bound(odometry.begin(), odometry.end(), time,
                                        [](const PathPose& pose, Time at) { return pose.time < at; });
    if (after != odometry.end() && after->time == time) return after->baseInMap;
    if (after == odometry.begin() || after == odometry.end()) {
        const PathPose& near = after == odometry.end() ? odometry.back() : *after;
        return std::chrono::abs(near.time - time) <= Gap ? std::optional(near.baseInMap) : std::nullopt;
    }
    const PathPose& before = *std::prev(after);
    if (after->time - before.time > Gap) return std::nullopt;
    const double share = std::chrono::duration<double>(time - before.time) /
                         std::chrono::duration<double>(after->time - before.time);
    return interpolated(before.baseInMap, after->baseInMap, share);
}

std::vector<PathPose> thinned(const std::vector<PathPose>& path, double apart) {
    std::vector<PathPose> kept;
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (!path[i].baseInMap.matrix().allFinite()) continue;
        const bool moved = kept.empty() ||
                           distanceBetween(kept.back().baseInMap, path[i].baseInMap) >= apart ||
                           angleBetween(kept.back().baseInMap, path[i].baseInMap) >= Turned;
        if (moved || i + 1 == path.size()) kept.push_back(path[i]);
    }
    return kept;
}

}  // namespace

double RobotPath::length() const {
    double sum = 0.0;
    for (std::size_t i = 1; i < poses.size(); ++i) {
        if (!poses[i].afterGap) sum += distanceBetween(poses[i - 1].baseInMap, poses[i].baseInMap);
    }
    return sum;
}

std::vector<PathPose> joinedPath(std::span<const PathAnchor> anchors, std::span<const PathPose> odometry,
                                 double apart) {
    std::vector<OdometryInMap> corrections;
    std::vector<PathPose> path;
    for (const PathAnchor& anchor : anchors) {
        path.push_back({anchor.time, anchor.baseInMap});
        if (odometry.empty()) continue;
        if (const auto at = odometryAt(odometry, anchor.time))
            corrections.push_back({anchor.time, anchor.baseInMap * at->inverse()});
    }
    if (corrections.empty()) return thinned(path, apart);
    const std::vector<PathPose> anchored = std::exchange(path, {});
    std::size_t next = 0;  // first correction after the pose
    for (const PathPose& pose : odometry) {
        while (next < corrections.size() && corrections[next].time <= pose.time) ++next;
        const OdometryInMap& before = corrections[next == 0 ? 0 : next - 1];
        const OdometryInMap& after = corrections[std::min(next, corrections.size() - 1)];
        const Pose byBefore = before.odomInMap * pose.baseInMap, byAfter = after.odomInMap * pose.baseInMap;
        const auto span = toSeconds(after.time - before.time);
        double share = span > 0.0 ? toSeconds(pose.time - before.time) / span : 0.0;
        if (distanceBetween(byBefore, byAfter) > MostDisagreement) share = share < 0.5 ? 0.0 : 1.0;
        PathPose placed{pose.time, interpolated(byBefore, byAfter, std::clamp(share, 0.0, 1.0))};
        placed.afterGap = !path.empty() && isGap(distanceBetween(path.back().baseInMap, placed.baseInMap),
                                                 placed.time - path.back().time);
        path.push_back(placed);
    }
    for (const PathPose& anchor : anchored) {
        if (anchor.time <= odometry.back().time + Beyond) continue;
        const PathPose& before = path.back();
        const bool gap =
            before.time <= odometry.back().time ||
            isGap(distanceBetween(before.baseInMap, anchor.baseInMap), anchor.time - before.time);
        path.push_back(anchor);
        path.back().afterGap = gap;
    }
    return thinned(path, apart);
}

}  // namespace leitstand
