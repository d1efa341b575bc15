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
    Time stamp{};                        ///< end of the scan, robot's clock
    Pose baseInMap = Pose::Identity();   ///< at that time
    Pose guessInMap = Pose::Identity();  ///< of base_link, by odometry alone since the scan before
    Pose odomInMap = Pose::Identity();   ///< odometry's frame in the map from then on
    ScanTrust trust = ScanTrust::Certain;
    std::uint8_t doubts = 0;    ///< bits of ScanDoubt
    std::uint64_t keyScan = 0;  ///< the scan's id if it entered the map; 0: it only localised
    IcpResult icp;              ///< meaningless for the first scan
    double seconds = 0.0;       ///< computing time [s]
};

/// The result of a scan: what the log keeps, in this order, and where the robot is.
struct MapUpdate {
    std::optional<KeyScanSample> keyScan;
    std::optional<ScanLinksSample> links;  ///< to the scans that it was registered against
    std::optional<ScanPosesSample> poses;
    /// Links of a loop that closed at this scan; poses change only later, by LiveMapper::problem(). Links
    /// that are not active are a question to the operator.
    std::optional<ScanLinksSample> loop;
    Localisation localisation;
    ScanPtr ready;  ///< the scan as it would enter: cleaned, labelled and thinned; null: it was not processed
    Pose scanInMap = Pose::Identity();  ///< where `ready` was taken
};

/// Where a robot was at its newest scan, in the map as it is now: decisions move it too.
struct RobotFix {
    Time stamp{};                       ///< end of that scan, robot's clock
    Pose baseInMap = Pose::Identity();  ///< at that time
    double certainty = 0.0;   ///< 0 to 1: by the scan's overlap with the map and its least certain direction
    std::uint8_t doubts = 0;  ///< bits of ScanDoubt
    double spinning = 0.0;    ///< SpinningWheels::way() [m]
    std::uint64_t part = 0;   ///< LiveKeyScan::part that it is in

    /// Returns `spinning` at @p now, robot's clock; 0 if no scan came lately, since only scans show it.
    [[nodiscard]] double spinningAt(Time now) const {
        constexpr std::chrono::seconds Fresh(6);  // two turns of a slow scanner, and a margin
        return now - stamp < Fresh ? spinning : 0.0;
    }
};

/// The result of solving.
struct Settled {
    std::optional<ScanLinksSample> links;  ///< loops that the others contradict: poses do not follow them
    std::optional<ScanPosesSample> poses;  ///< of scans that moved noticeably
    double largest = 0.0;                  ///< largest shift of a scan [m]
};

/// Settings for registering a scan again.
struct RetrySettings {
    MatchSettings match;             ///< its wide schedule is used
    std::optional<Pose> guessInMap;  ///< start of the search; empty: the scan's present pose
};

}  // namespace leitstand
