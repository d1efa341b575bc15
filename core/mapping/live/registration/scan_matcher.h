#pragma once

#include <cstdint>
#include <span>

#include "core/base/pose.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/loops/loop_closer.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/map/live_scan.h"
#include "core/mapping/live/map/local_map.h"
#include "core/mapping/live/registration/robot_track.h"
#include "core/mapping/live/scan_work.h"

namespace leitstand {

/// The expected pose of a scan in the map, and the motion of its robot to it.
struct ExpectedScan {
    Pose scanInMap = Pose::Identity();
    Step step;
};

/// Returns where @p live is expected, by what is known of @p robot's motion.
[[nodiscard]] ExpectedScan expectedAt(const LiveScan& live, const RobotTrack& robot);

/// Returns whether @p live, which came to lie at @p found instead of @p guess, was taken while something
/// pushed or held the robot. Its points were assembled by odometry's motion within the turn.
[[nodiscard]] bool wasPushed(const LiveScan& live, const Pose& guess, const Pose& found, const Step& step,
                             const KeyScanRule& rule);

/// A robot's newest scan, as it is to be registered.
struct ScanToMatch {
    const LiveScan& live;
    const RobotTrack& robot;
    Pose guess;  ///< expectedAt()
    Step step;
    std::span<const PlacedBody> others;  ///< robots that the scan may show
    const LiveSettings& preparing;       ///< settings by which it is cleaned
};

/// Registers scans against the key scans around them. Also tries what may keep a scan from fitting: a turn
/// that the wheels bent, or a robot that stood while they spun.
class ScanMatcher {
public:
    /// All arguments must outlive it.
    ScanMatcher(const LiveMap& map, const LoopCloser& loops, const LiveSettings& settings)
        : m_map(map), m_loops(loops), m_settings(settings) {}

    void mapChanged() { m_stale = true; }  ///< the surroundings of robots are looked up again
    /// Returns the scans around @p place that @p robot's newest scans are connected with; valid until the
    /// next call.
    [[nodiscard]] const LocalMap& localAt(const Pose& place, const RobotTrack& robot);
    /// Returns how @p scan fits. @p ready: the scan as it was expected; after the call, the scan as it fits.
    [[nodiscard]] Match match(const ScanToMatch& scan, ReadyScan& ready);
    /// Returns whether @p scan, which does not fit, was taken at its pose by odometry. It sees new ground,
    /// and neither fills what the scans around it looked through, nor do they fill what it looked through.
    [[nodiscard]] bool isHeldByOdometry(const ScanToMatch& scan, const ReadyScan& ready);

private:
    [[nodiscard]] Match matched(const ScanToMatch& scan, const PointCloud& cloud);
    /// Takes the drift within the turn out of @p ready, if it then fits better than by @p match.
    void refine(const ScanToMatch& scan, ReadyScan& ready, Match& match);
    /// Tries whether the wheels spun, for a @p scan that does not fit, or fits away from odometry's pose. Its
    /// points were assembled as if the robot had moved as its wheels did. Here they are assembled as if it
    /// had only turned. The wheels spun if that fits, or fits better, where the robot was last.
    void stand(const ScanToMatch& scan, ReadyScan& ready, Match& match);
    [[nodiscard]] const LiveKeyScan* find(std::uint64_t id) const;
    /// Returns LiveKeyScan::part of @p robot's newest key scan.
    [[nodiscard]] std::uint64_t partOf(const RobotTrack& robot) const;

    const LiveMap& m_map;
    const LoopCloser& m_loops;
    const LiveSettings& m_settings;
    LocalMap m_local;
    Pose m_place = Pose::Identity();  ///< of the local map
    std::uint64_t m_key = 0;          ///< RobotTrack::key of its robot
    bool m_stale = true;
};

}  // namespace leitstand
