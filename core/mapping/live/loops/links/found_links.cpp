#include "core/mapping/live/loops/links/found_links.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

#include <Eigen/Eigenvalues>

namespace leitstand {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Deviation where the robot's motion was not measured [m, rad].
constexpr double Unmeasured = 1.0;

/// Returns the share of each direction that surfaces hold, in the map's axes. Turns count as shifts at the
/// arm.
Information heldBy(const IcpResult& icp, const MatchSettings& match) {
    assert(match.openBelow > IcpResult::UncertainBelow);
    const Eigen::SelfAdjointEigenSolver<Information> solver(icp.information);
    Information held = Information::Zero();
    for (Eigen::Index i = 0; i < 6; ++i) {
        // From where odometry counts alone to where it does not count.
        const double certainty = 3.0 * solver.eigenvalues()[i] - IcpResult::UncertainBelow;
        const double share = std::clamp(certainty / (match.openBelow - IcpResult::UncertainBelow), 0.0, 1.0);
        held += share * solver.eigenvectors().col(i) * solver.eigenvectors().col(i).transpose();
    }
    return held;
}

/// Returns a scan's axes in the map, for translation and rotation.
Information axesOf(const Pose& scanInMap) {
    Information axes = Information::Zero();
    axes.topLeftCorner<3, 3>() = axes.bottomRightCorner<3, 3>() = scanInMap.linear();
    return axes;
}

/// Returns 1 for shifts, the arm for turns.
Vector6 armsOf(const LoopSettings& loops) {
    Vector6 arms;
    arms << 1.0, 1.0, 1.0, loops.arm, loops.arm, loops.arm;
    return arms;
}

Link odometryLink(const Entry& entry, const MatchSettings& match) {
    const LiveKeyScan &before = *entry.predecessor, &scan = entry.scan;
    Link link = linkBetween(before, scan, LinkKind::Odometry);
    if (!scan.scan->hasOdometry || !before.scan->hasOdometry || scan.odometryFrame != before.odometryFrame) {
        link.information = Information::Identity() / (Unmeasured * Unmeasured);
        return link;
    }
    link.pose = before.sensorByWheels().inverse() * scan.sensorByWheels();
    const Vector6 deviation = match.odometry.deviation(link.pose.translation().norm(),
                                                       Eigen::AngleAxisd(link.pose.linear()).angle());
    link.information = deviation.cwiseAbs2().cwiseInverse().asDiagonal();
    return link;
}

}  // namespace

Link linkBetween(const LiveKeyScan& from, const LiveKeyScan& to, LinkKind kind) {
    Link link;
    link.from = from.id;
    link.to = to.id;
    link.kind = kind;
    link.pose = from.pose.scanInMap.inverse() * to.pose.scanInMap;
    return link;
}

Information informationOf(const IcpResult& icp, const Pose& scanInMap, const LoopSettings& loops,
                          const MatchSettings& match) {
    const Vector6 scale = armsOf(loops) / loops.matchDeviation;
    const Information inMap = scale.asDiagonal() * heldBy(icp, match) * scale.asDiagonal();
    const Information axes = axesOf(scanInMap);
    return axes.transpose() * inMap * axes;
}

std::vector<Link> linksOf(const Entry& entry, const LoopSettings& loops, const MatchSettings& match) {
    std::vector<Link> links;
    const bool fits = entry.match.doubts == 0 && !entry.against.empty();
    const Pose& inMap = entry.scan.pose.scanInMap;
    if (entry.predecessor != nullptr) {
        Link link = odometryLink(entry, match);
        if (fits) {
            const Vector6 arms = armsOf(loops);
            const Information axes = axesOf(inMap);
            const Information free =
                axes.transpose() * (Information::Identity() - heldBy(entry.match.icp, match)) * axes;
            const Information open = arms.cwiseInverse().asDiagonal() * free * arms.asDiagonal();
            link.information = open.transpose() * link.information * open;
        }
        links.push_back(std::move(link));
    }
    if (!fits) return links;
    const Information information = informationOf(entry.match.icp, inMap, loops, match);
    const auto count = std::min(entry.against.size(), static_cast<std::size_t>(loops.linksAScan));
    for (const LiveKeyScan& other : entry.against.first(count)) {
        Link link = linkBetween(other, entry.scan, LinkKind::Match);
        link.information = information / static_cast<double>(count);
        links.push_back(std::move(link));
    }
    return links;
}

}  // namespace leitstand
