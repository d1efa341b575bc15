#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/event/map_samples.h"
#include "core/event/scan_links.h"
#include "core/event/scan_pose.h"
#include "core/mapping/live/live_settings.h"
#include "core/registration/icp.h"

namespace leitstand {

/// Where a robot is in the map, by its newest scan.
struct Localisation {
    std::string robot;
    Time stamp{};                       ///< end of the scan, robot's clock
    Pose baseInMap = Pose::Identity();  ///< base_link at that time
    /// Pose of base_link at that time, predicted by odometry from the previous scan.
    Pose guessInMap = Pose::Identity();
    Pose odomInMap = Pose::Identity();  ///< pose of the odometry's frame in the map from then on
    ScanTrust trust = ScanTrust::Certain;
    std::uint8_t doubts = 0;  ///< bits of ScanDoubt
    /// The scan's id if it entered the map; 0: the scan was only used to locate the robot.
    std::uint64_t keyScan = 0;
    IcpResult icp;         ///< meaningless for the first scan
    double seconds = 0.0;  ///< computing time [s]
};

/// The result of adding a scan: where the robot is, and what the log stores, in this order.
struct MapUpdate {
    std::optional<KeyScanSample> keyScan;
    std::optional<ScanLinksSample> links;  ///< links to the scans that it was registered against
    std::optional<ScanPosesSample> poses;
    /// Links of a loop that closed at this scan. Poses change only later, by LiveMapper::problem(). Links
    /// that are not active are a question to the operator.
    std::optional<ScanLinksSample> loop;
    Localisation localisation;
    /// The scan as it would enter the map: cleaned, labelled and thinned; null: it was not processed.
    ScanPtr ready;
    Pose scanInMap = Pose::Identity();  ///< where `ready` was taken
};

/// Where a robot was at its newest scan, in the present map. Decisions move it too.
struct RobotFix {
    Time stamp{};                       ///< end of that scan, robot's clock
    Pose baseInMap = Pose::Identity();  ///< base_link at that time
    double certainty = 0.0;  ///< 0 to 1: from the scan's overlap with the map and its least certain direction
    std::uint8_t doubts = 0;  ///< bits of ScanDoubt
    double spinning = 0.0;    ///< SpinningWheels::way() [m]
    std::uint64_t part = 0;   ///< LiveKeyScan::part in which the robot is

    /// Returns `spinning` at @p now (robot's clock). 0 if no scan was taken recently, since only scans show
    /// it.
    [[nodiscard]] double spinningAt(Time now) const {
        constexpr std::chrono::seconds Fresh(6);  // two turns of a slow scanner, and a margin
        return now - stamp < Fresh ? spinning : 0.0;
    }
};

/// The result of solving.
struct Settled {
    /// Loops that the other links contradict: poses do not follow them.
    std::optional<ScanLinksSample> links;
    std::optional<ScanPosesSample> poses;  ///< new poses of scans that moved noticeably
    double largest = 0.0;                  ///< largest shift of a scan [m]
};

/// Settings for registering a scan again.
struct RetrySettings {
    MatchSettings match;             ///< settings for matching; the `wide` distances are used
    std::optional<Pose> guessInMap;  ///< start of the search; empty: the scan's present pose
};

}  // namespace leitstand
