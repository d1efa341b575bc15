#pragma once

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "core/mapping/live/growing_map.h"
#include "core/mapping/live/map/live_scan.h"
#include "core/mapping/live/map/map_update.h"
#include "core/mapping/live/scan_work.h"

namespace leitstand {

/// Registers scans into a map, and decides which become key scans.
class ScanRegistration {
public:
    explicit ScanRegistration(GrowingMap& map) : m_map(map) {}

    /// As LiveMapper::add().
    [[nodiscard]] MapUpdate add(const LiveScan& live, Time now, std::span<const PlacedBody> others);

private:
    /// How a robot's newest scan fits the map, before it is decided whether it enters.
    struct Registered {
        bool first = false, begins = false;  ///< the first scan of a part; of a part beside those that exist
        Pose guess = Pose::Identity();
        Step step;
        ReadyScan ready;
        Match match;
        double fresh = 1.0;                  ///< share of its points that see new ground
        std::vector<std::uint64_t> against;  ///< ids of scans that it was matched with, nearest first
        bool held = false;                   ///< it does not fit, but ScanMatcher::isHeldByOdometry()
        bool lost = false;                   ///< it does not fit, and is not `held`
        bool pushed = false;                 ///< wasPushed()
    };
    /// Registers @p live. Returns the doubt if it cannot be registered at all: too few points to begin with,
    /// or its robot's pose is unknown.
    [[nodiscard]] std::variant<Registered, ScanDoubt> registered(const LiveScan& live,
                                                                 const RobotTrack& robot,
                                                                 std::span<const PlacedBody> others);
    /// Returns whether @p found becomes a key scan. Sets RobotTrack::waited of @p robot: whether it is left
    /// out for the next one.
    [[nodiscard]] bool isKeyScan(RobotTrack& robot, const LiveScan& live, const Registered& found) const;
    /// Enters @p found into the map. Adds to @p update what is to be logged.
    void enter(MapUpdate& update, RobotTrack& robot, const LiveScan& live, const Registered& found, Time now);
    /// Updates @p robot's wheels, scanner and pose by @p found.
    void advance(RobotTrack& robot, const LiveScan& live, const Registered& found) const;
    /// Links the newest key scan, which was matched with @p against, and looks for a loop at it.
    void link(MapUpdate& update, const RobotTrack& robot, std::span<const std::uint64_t> against,
              const Match& match, Time now);
    [[nodiscard]] bool enters(const RobotTrack& robot, const Pose& scanInMap, double fresh) const;
    /// Returns whether the map can do without the scan at @p scanInMap, if the next one enters.
    [[nodiscard]] bool canWait(const RobotTrack& robot, const Pose& scanInMap, double fresh) const;
    /// Returns the pose of a scan that begins a part of its own, aside from the map. @p up: against gravity,
    /// in the scan's frame.
    [[nodiscard]] Pose aside(const Eigen::Vector3d& up) const;
    /// Returns whether no scan counts in the part of @p robot; false if the operator has placed the robot, or
    /// it has no key scan.
    [[nodiscard]] bool isAlone(const RobotTrack& robot);
    /// Returns whether the next scan of @p robot, if it is whole enough, begins a part beside those that
    /// exist. Also true if its part is gone, since all of it was set aside.
    [[nodiscard]] bool beginsPart(const RobotTrack& robot);
    /// Returns the part of the next scan of @p robot, which is looked for around @p guess.
    [[nodiscard]] std::uint64_t partFor(const RobotTrack& robot, const Pose& guess);
    /// Returns the settings for the next scan of @p robot, which is looked for around @p guess.
    [[nodiscard]] const LiveSettings& preparing(const RobotTrack& robot, const Pose& guess);

    GrowingMap& m_map;
};

}  // namespace leitstand
