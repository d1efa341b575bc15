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

/// Where a scan is expected in the map, and how its robot came there.
struct ExpectedScan {
    Pose scanInMap = Pose::Identity();
    Step step;
};

/// Of @p live, by what is known of @p robot's way.
[[nodiscard]] ExpectedScan expectedAt(const LiveScan& live, const RobotTrack& robot);

/// Whether @p live, which came to lie at @p found instead of at @p guess, was taken while something pushed or
/// held the robot: its points were put together by what odometry told of the motion within the turn.
[[nodiscard]] bool wasPushed(const LiveScan& live, const Pose& guess, const Pose& found, const Step& step,
                             const KeyScanRule& rule);

/// A robot's newest scan, as it is to be registered.
struct ScanToMatch {
    const LiveScan& live;
    const RobotTrack& robot;
    Pose guess;  ///< expectedAt()
    Step step;
    std::span<const PlacedBody> others;  ///< robots that the scan may show
    const LiveSettings& preparing;       ///< by which it is cleaned
};

/// Registers scans against the key scans about them, and tries what may keep one from fitting: a turn that
/// the wheels bent, a robot that stood while they spun.
class ScanMatcher {
public:
    /// All must outlive it.
    ScanMatcher(const LiveMap& map, const LoopCloser& loops, const LiveSettings& settings)
        : m_map(map), m_loops(loops), m_settings(settings) {}

    void mapChanged() { m_stale = true; }  ///< what is about robots is looked up again
    /// The scans about @p place that @p robot's newest scans hang together with; valid until the next call.
    [[nodiscard]] const LocalMap& localAt(const Pose& place, const RobotTrack& robot);
    /// How @p scan fits, of which @p ready is what was expected; that is what fits, after.
    [[nodiscard]] Match match(const ScanToMatch& scan, ReadyScan& ready);
    /// Whether @p scan, which does not fit, was taken where odometry says: it sees ground that is new, and
    /// neither fills what scans about it looked through, nor do these.
    [[nodiscard]] bool isHeldByOdometry(const ScanToMatch& scan, const ReadyScan& ready);

private:
    [[nodiscard]] Match matched(const ScanToMatch& scan, const PointCloud& cloud);
    /// Takes the drift within the turn out of @p ready, where that lets it fit better than @p match says.
    void refine(const ScanToMatch& scan, ReadyScan& ready, Match& match);
    /// @p scan, which does not fit, or elsewhere than where odometry has it, was put together as if the robot
    /// had moved as its wheels did: where it fits, or fits better, to where the robot was last, put together
    /// as if that only turned, the wheels spun.
    void stand(const ScanToMatch& scan, ReadyScan& ready, Match& match);
    [[nodiscard]] const LiveKeyScan* find(std::uint64_t id) const;
    /// LiveKeyScan::part of @p robot's newest key scan.
    [[nodiscard]] std::uint64_t partOf(const RobotTrack& robot) const;

    const LiveMap& m_map;
    const LoopCloser& m_loops;
    const LiveSettings& m_settings;
    LocalMap m_local;
    Pose m_place = Pose::Identity();  ///< that it is about
    std::uint64_t m_key = 0;          ///< RobotTrack::key of the robot that it is for
    bool m_stale = true;
};

}  // namespace leitstand
