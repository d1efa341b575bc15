#pragma once

#include <cstdint>
#include <span>

#include "core/base/pose.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/loops/links/map_graph.h"
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

/// Returns the expected pose of @p live, from what is known of @p robot's motion.
[[nodiscard]] ExpectedScan expectedAt(const LiveScan& live, const RobotTrack& robot);

/// Returns whether something pushed or held the robot while @p live was taken: it fits at @p found, too far
/// from @p guess. Its points are then distorted, since they were assembled with odometry's motion during the
/// turn.
[[nodiscard]] bool wasPushed(const LiveScan& live, const Pose& guess, const Pose& found, const Step& step,
                             const KeyScanRule& rule);

/// A robot's newest scan that shall be registered.
struct ScanToMatch {
    const LiveScan& live;
    const RobotTrack& robot;
    Pose guess;  ///< result of expectedAt()
    Step step;
    std::span<const PlacedBody> others;  ///< robots that the scan may show
    const LiveSettings& preparing;       ///< settings for cleaning the scan
};

/// Registers scans against the key scans around them. Also tries to correct a turn of the scanner during
/// which the wheels measured the motion wrongly, and a robot that stood while its wheels spun.
class ScanMatcher {
public:
    /// All arguments must outlive this object.
    ScanMatcher(const LiveMap& map, const MapGraph& graph, const LiveSettings& settings)
        : m_map(map), m_graph(graph), m_settings(settings) {}

    void mapChanged() { m_stale = true; }  ///< the local map is made again when it is next used
    /// Returns the local map around @p place, made of scans that are connected with @p robot's newest key
    /// scan. Valid until the next call.
    [[nodiscard]] const LocalMap& localAt(const Pose& place, const RobotTrack& robot);
    /// Returns how @p scan fits. @p ready: the scan prepared at its expected pose. The call replaces it by
    /// the corrected scan that fits best.
    [[nodiscard]] Match match(const ScanToMatch& scan, ReadyScan& ready);
    /// Returns whether @p scan, which does not fit, may enter at its pose by odometry. It must see new
    /// ground. Its points must not lie in the free space of the scans around it, and their points not in its
    /// free space.
    [[nodiscard]] bool isHeldByOdometry(const ScanToMatch& scan, const ReadyScan& ready);

private:
    [[nodiscard]] Match matched(const ScanToMatch& scan, const PointCloud& cloud);
    /// Removes odometry's drift during the turn from @p ready and updates @p match, if the scan then fits
    /// better.
    void refine(const ScanToMatch& scan, ReadyScan& ready, Match& match);
    /// Tries whether the wheels spun, for a @p scan that does not fit, or fits away from odometry's pose. Its
    /// points were assembled as if the robot had moved as its wheels did. Here they are assembled as if the
    /// robot had only turned. If the scan then fits, or fits better, at the robot's last position, the wheels
    /// spun.
    void stand(const ScanToMatch& scan, ReadyScan& ready, Match& match);
    [[nodiscard]] const LiveKeyScan* find(std::uint64_t id) const;
    /// Returns LiveKeyScan::part of @p robot's newest key scan.
    [[nodiscard]] std::uint64_t partOf(const RobotTrack& robot) const;

    const LiveMap& m_map;
    const MapGraph& m_graph;
    const LiveSettings& m_settings;
    LocalMap m_local;
    Pose m_place = Pose::Identity();  ///< place for which `m_local` was made ...
    std::uint64_t m_key = 0;          ///< ... and RobotTrack::key of the robot then
    bool m_stale = true;
};

}  // namespace leitstand
