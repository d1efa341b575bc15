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

/// Returns the scan of @p live with points on @p body and @p others, and those outside the area of
/// @p settings, turned into no echo. The scan is at @p scanInMap; its grid stays.
[[nodiscard]] Scan cleaned(const LiveScan& live, const RobotBody& body, const Pose& scanInMap,
                           const LiveSettings& settings, std::span<const PlacedBody> others = {});

/// Returns the scan of @p live, made ready: it is cleaned(), mixed pixels are removed, and it is labelled and
/// reduced. The arguments are those of cleaned().
[[nodiscard]] ReadyScan readyScan(const LiveScan& live, const RobotBody& body, const Pose& scanInMap,
                                  const LiveSettings& settings, std::span<const PlacedBody> others = {});

/// Returns @p scan with only the points at the indices @p kept, unorganised. Intensities, labels and shades
/// of these points are kept, and so are name, times and pose of the scan.
[[nodiscard]] Scan selected(const Scan& scan, const std::vector<std::size_t>& kept);

/// Returns @p scan as the live map keeps it: with shades for display instead of the intensities, which the
/// log has.
[[nodiscard]] ScanPtr keptOf(const ScanPtr& scan);

/// Returns the bytes of memory that a key scan takes now: its points, and its cloud for matching if that is
/// in memory.
[[nodiscard]] std::size_t memoryOf(const LiveKeyScan& scan);

/// Returns the cloud for matching of a key scan whose ReadyScan::reduced is gone. It is made again of
/// @p scan, the points that the log has.
[[nodiscard]] PointCloud reducedAgain(const Scan& scan, const MatchSettings& settings);

/// The result of matching a scan.
struct Match {
    Pose scanInMap = Pose::Identity();  ///< the guess where there are doubts
    IcpResult icp;
    std::uint8_t doubts = 0;  ///< bits of ScanDoubt
    bool spun = false;        ///< the wheels spun: the scan fits far behind odometry's pose, beyond doubt
};

/// Returns whether a map may begin with @p live, whose cloud for matching is @p reduced: it is a whole turn
/// or sweep, or nearly so, and has enough points.
[[nodiscard]] bool canBegin(const LiveScan& live, const PointCloud& reduced, const FitSettings& fit);

/// The motion of a robot to its present scan.
struct Step {
    bool measured = false;         ///< whether odometry measured it: the match must not jump against it
    bool trusted = false;          ///< whether odometry is sure enough to look for the match nearby
    double way = 0.0, turn = 0.0;  ///< since the last certain scan [m, rad]
    double openWay = 0.0;          ///< since the surfaces around the robot held all directions [m]
    /// By odometry since the last certain scan, along the map's axes [m].
    Eigen::Vector3d moved = Eigen::Vector3d::Zero();
};

/// Matches @p cloud with @p local, starting at @p guess. Tries the schedule of pair distances that suits
/// @p step, then the others while there are doubts. @p up: against gravity, in the scan's frame; empty:
/// unknown.
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

/// Returns @p scanInMap turned towards level: @p share (0 to 1) of its disagreement with gravity is removed.
/// @p up: against gravity, in the scan's frame.
[[nodiscard]] Pose levelled(const Pose& scanInMap, const Eigen::Vector3d& up, double share);

/// Returns the direction against gravity in the frame of @p scan: as measured, or else by its pose in the
/// map.
[[nodiscard]] Eigen::Vector3d upOf(const LiveKeyScan& scan);

}  // namespace leitstand
