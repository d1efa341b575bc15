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

/// A scan that is prepared for the live map.
struct ReadyScan {
    ScanPtr scan;        ///< cleaned, labelled and thinned, finite points only
    PointCloud reduced;  ///< cloud for matching, with normals
};

/// Returns the scan of @p live at @p scanInMap. Points on @p body or @p others, and points outside the area
/// of @p settings, become "no echo". The scan keeps its grid.
[[nodiscard]] Scan cleaned(const LiveScan& live, const RobotBody& body, const Pose& scanInMap,
                           const LiveSettings& settings, std::span<const PlacedBody> others = {});

/// Prepares the scan of @p live: it is cleaned(), mixed pixels are removed, and it is labelled and reduced.
/// The arguments are those of cleaned().
[[nodiscard]] ReadyScan readyScan(const LiveScan& live, const RobotBody& body, const Pose& scanInMap,
                                  const LiveSettings& settings, std::span<const PlacedBody> others = {});

/// Returns @p scan with only the points at the indices @p kept, unorganised. These points keep their
/// intensities, labels and shades. The scan keeps name, times and pose.
[[nodiscard]] Scan selected(const Scan& scan, const std::vector<std::size_t>& kept);

/// Returns @p scan as the live map keeps it: with shades for display instead of intensities. The log has the
/// intensities.
[[nodiscard]] ScanPtr keptOf(const ScanPtr& scan);

/// Returns how much memory a key scan uses now [B]: its points, and its cloud for matching if that is in
/// memory.
[[nodiscard]] std::size_t memoryOf(const LiveKeyScan& scan);

/// Makes the cloud for matching of a key scan again, after its ReadyScan::reduced was released. @p scan: its
/// points as the log has them.
[[nodiscard]] PointCloud reducedAgain(const Scan& scan, const MatchSettings& settings);

/// The result of matching a scan.
struct Match {
    Pose scanInMap = Pose::Identity();  ///< pose of the scan; the guess if there are doubts
    IcpResult icp;
    std::uint8_t doubts = 0;  ///< bits of ScanDoubt
    bool spun = false;        ///< whether the wheels certainly spun: the scan fits far behind odometry's pose
};

/// Returns whether a map may begin with @p live, whose cloud for matching is @p reduced. It must be a nearly
/// complete turn or sweep, and have enough points.
[[nodiscard]] bool canBegin(const LiveScan& live, const PointCloud& reduced, const FitSettings& fit);

/// The motion of a robot to its present scan.
struct Step {
    bool measured = false;         ///< whether odometry measured the motion: the match must not contradict it
    bool trusted = false;          ///< whether odometry is reliable enough to look for the match nearby
    double way = 0.0, turn = 0.0;  ///< how far it drove and turned since the last certain scan [m, rad]
    double openWay = 0.0;  ///< distance driven since surfaces around the robot held all directions [m]
    /// Translation since the last certain scan, by odometry, along the map's axes [m].
    Eigen::Vector3d moved = Eigen::Vector3d::Zero();
};

/// Matches @p cloud with @p local, starting at @p guess. Tries the pair distances that suit @p step, then the
/// others as long as there are doubts. @p up: upward direction in the scan's frame; empty: unknown.
[[nodiscard]] Match match(const PointCloud& cloud, const LocalMap& local, const Pose& guess, const Step& step,
                          const std::optional<Eigen::Vector3d>& up, const MatchSettings& settings,
                          const FitSettings& fit);
/// As above, with the pair distances @p schedule only.
[[nodiscard]] Match match(const PointCloud& cloud, const LocalMap& local, const Pose& guess, const Step& step,
                          const std::optional<Eigen::Vector3d>& up, const MatchSettings& settings,
                          const FitSettings& fit, const std::vector<double>& schedule);

/// Returns the share of points of @p cloud (at @p scanInMap) that are farther than @p distance [m] from all
/// points of @p local.
[[nodiscard]] double newGround(const PointCloud& cloud, const LocalMap& local, const Pose& scanInMap,
                               double distance);

/// Returns @p scanInMap turned towards level. @p share: how much of the disagreement with gravity is removed,
/// 0 to 1. @p up: upward direction in the scan's frame.
[[nodiscard]] Pose levelled(const Pose& scanInMap, const Eigen::Vector3d& up, double share);

/// Returns the upward direction in the frame of @p scan, as measured. If it was not measured, it follows from
/// the pose in the map.
[[nodiscard]] Eigen::Vector3d upOf(const LiveKeyScan& scan);

}  // namespace leitstand
