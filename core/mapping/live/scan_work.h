#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "core/base/pose.h"
#include "core/cloud/scan.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/map/live_scan.h"
#include "core/mapping/live/map/local_map.h"
#include "core/registration/icp.h"

namespace leitstand {

/// A scan made ready for the live map.
struct ReadyScan {
    ScanPtr scan;        ///< cleaned, labelled and thinned, finite points only
    PointCloud reduced;  ///< for matching, with normals
};

/// Returns @p live's scan, as the scanner gave it, without @p body, @p others and what @p settings crop, seen
/// from @p scanInMap.
[[nodiscard]] Scan cleaned(const LiveScan& live, const RobotBody& body, const Pose& scanInMap,
                           const LiveSettings& settings, std::span<const PlacedBody> others = {});

/// Cleans @p live of @p body, @p others, mixed pixels and what @p settings crop, seen from @p scanInMap.
/// Labels and reduces it.
[[nodiscard]] ReadyScan readyScan(const LiveScan& live, const RobotBody& body, const Pose& scanInMap,
                                  const LiveSettings& settings, std::span<const PlacedBody> others = {});

/// Returns the points @p kept of @p scan, unorganised, with all other values of it and them.
[[nodiscard]] Scan selected(const Scan& scan, const std::vector<std::size_t>& kept);

/// Returns @p scan as the live map keeps it: without intensities, which the log has.
[[nodiscard]] ScanPtr keptOf(const ScanPtr& scan);

/// Returns the bytes that a key scan takes in the live map: its points, and its cloud for matching.
[[nodiscard]] std::size_t memoryOf(const LiveKeyScan& scan);

/// Returns the cloud that readyScan() made of a key scan, from its points in the log.
[[nodiscard]] PointCloud reducedAgain(const Scan& scan, const MatchSettings& settings);

/// The result of matching a scan.
struct Match {
    Pose scanInMap = Pose::Identity();  ///< the guess where there are doubts
    IcpResult icp;
    std::uint8_t doubts = 0;  ///< bits of ScanDoubt
    bool spun = false;        ///< the wheels spun: it fits far behind odometry's pose, beyond doubt
};

/// Returns whether a map may begin with @p live, whose cloud for matching is @p reduced: it is a whole turn
/// or sweep, or nearly so, and has enough points.
[[nodiscard]] bool canBegin(const LiveScan& live, const PointCloud& reduced, const FitSettings& fit);

/// The motion of a robot from the scan before to this one.
struct Step {
    bool measured = false;         ///< by odometry: the match must not jump against it
    bool trusted = false;          ///< so much that the match is looked for nearby
    double way = 0.0, turn = 0.0;  ///< since a scan was certain [m, rad]
    double openWay = 0.0;          ///< since the surfaces around the robot held all directions [m]
    /// By odometry, since a scan was certain; in the map [m].
    Eigen::Vector3d moved = Eigen::Vector3d::Zero();
};

/// Matches @p cloud with @p local, starting at @p guess. Uses the schedule that @p step asks for, and the
/// others if that leaves doubts. @p up: against gravity, in the scan's frame; empty: unknown.
[[nodiscard]] Match match(const PointCloud& cloud, const LocalMap& local, const Pose& guess, const Step& step,
                          const std::optional<Eigen::Vector3d>& up, const MatchSettings& settings,
                          const FitSettings& fit);
/// The same with @p schedule of pair distances only.
[[nodiscard]] Match match(const PointCloud& cloud, const LocalMap& local, const Pose& guess, const Step& step,
                          const std::optional<Eigen::Vector3d>& up, const MatchSettings& settings,
                          const FitSettings& fit, const std::vector<double>& schedule);

/// Returns the share of @p cloud's points at @p scanInMap that are farther than @p distance [m] from all of
/// @p local.
[[nodiscard]] double newGround(const PointCloud& cloud, const LocalMap& local, const Pose& scanInMap,
                               double distance);

/// Returns @p scanInMap turned so that a @p share of its disagreement with gravity (@p up in its frame) is
/// gone.
[[nodiscard]] Pose levelled(const Pose& scanInMap, const Eigen::Vector3d& up, double share);

/// Returns the direction against gravity in the frame of @p scan: as measured, else as it stands in the map.
[[nodiscard]] Eigen::Vector3d upOf(const LiveKeyScan& scan);

}  // namespace leitstand
