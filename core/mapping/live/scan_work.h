#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "core/base/pose.h"
#include "core/cloud/scan.h"
#include "core/event/map_samples.h"
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

/// @p live's scan, as the scanner gave it, without @p body and @p others, and without what @p settings crop,
/// seen from @p scanInMap.
[[nodiscard]] Scan cleaned(const LiveScan& live, const RobotBody& body, const Pose& scanInMap,
                           const LiveSettings& settings, std::span<const PlacedBody> others = {});

/// Cleans @p live of @p body and @p others, of mixed pixels and of what @p settings crop, seen from
/// @p scanInMap; labels and reduces it.
[[nodiscard]] ReadyScan readyScan(const LiveScan& live, const RobotBody& body, const Pose& scanInMap,
                                  const LiveSettings& settings, std::span<const PlacedBody> others = {});

/// The points @p kept of @p scan, unorganised, with all else that is known of it and them.
[[nodiscard]] Scan selected(const Scan& scan, const std::vector<std::size_t>& kept);

/// What the live map keeps of @p scan: nobody asks there how bright its points were, and the log has it.
[[nodiscard]] ScanPtr keptOf(const ScanPtr& scan);

/// Bytes that a key scan takes in the live map: its points, and what is matched of them.
[[nodiscard]] std::size_t memoryOf(const LiveKeyScan& scan);

/// What readyScan() made of a key scan, from its points as the log has them.
[[nodiscard]] PointCloud reducedAgain(const Scan& scan, const MatchSettings& settings);

/// What the match of a scan came to.
struct Match {
    Pose scanInMap = Pose::Identity();  ///< the guess where there are doubts
    IcpResult icp;
    std::uint8_t doubts = 0;  ///< bits of ScanDoubt
    bool spun = false;        ///< the wheels spun: it fits far behind where odometry says, beyond doubt
};

/// Whether a map may begin with @p live, of which @p reduced is to be matched: it is of a whole turn or
/// sweep, or nearly so, and has enough points.
[[nodiscard]] bool canBegin(const LiveScan& live, const PointCloud& reduced, const FitSettings& fit);

/// How a robot came from the scan before to this one.
struct Step {
    bool measured = false;         ///< by odometry: the match must not jump against it
    bool trusted = false;          ///< so well that the match is looked for nearby
    double way = 0.0, turn = 0.0;  ///< since a scan was certain [m, rad]
    double openWay = 0.0;          ///< since the surfaces about the robot held all directions [m]
    Eigen::Vector3d moved =
        Eigen::Vector3d::Zero();  ///< by odometry, since a scan was certain; in the map [m]
};

/// Matches @p cloud with @p local, starting at @p guess: by the schedule that the step asks for, and where
/// that leaves doubts by the others. @p up: against gravity, in the scan's frame; empty:
/// unknown.
[[nodiscard]] Match match(const PointCloud& cloud, const LocalMap& local, const Pose& guess, const Step& step,
                          const std::optional<Eigen::Vector3d>& up, const MatchSettings& settings,
                          const FitSettings& fit);
/// The same with @p schedule of pair distances only.
[[nodiscard]] Match match(const PointCloud& cloud, const LocalMap& local, const Pose& guess, const Step& step,
                          const std::optional<Eigen::Vector3d>& up, const MatchSettings& settings,
                          const FitSettings& fit, const std::vector<double>& schedule);

/// Share of @p cloud's points at @p scanInMap that are farther than @p distance [m] from all of @p local.
[[nodiscard]] double newGround(const PointCloud& cloud, const LocalMap& local, const Pose& scanInMap,
                               double distance);

/// @p scanInMap turned so that a share of its disagreement with gravity (@p up in its frame) is gone.
[[nodiscard]] Pose levelled(const Pose& scanInMap, const Eigen::Vector3d& up, double share);

/// Against gravity in the frame of @p scan: as it was measured, else as it stands in the map.
[[nodiscard]] Eigen::Vector3d upOf(const LiveKeyScan& scan);

}  // namespace leitstand
