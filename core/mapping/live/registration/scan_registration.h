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

/// Registers scans into a map, and decides which of them become key scans.
class ScanRegistration {
public:
    explicit ScanRegistration(GrowingMap& map) : m_map(map) {}

    /// As LiveMapper::add().
    [[nodiscard]] MapUpdate add(const LiveScan& live, Time now, std::span<const PlacedBody> others);

private:
    /// How a robot's newest scan fits the map, before it is decided whether it enters.
    struct Registered {
        /// The first scan of a part; whether this is a new part beside existing ones.
        bool first = false, begins = false;
        Pose guess = Pose::Identity();
        Step step;
        ReadyScan ready;
        Match match;
        double fresh = 1.0;                  ///< share of points on new ground
        std::vector<std::uint64_t> against;  ///< ids of scans that it was matched with, nearest first
        bool held = false;                   ///< it does not fit, but ScanMatcher::isHeldByOdometry() is true
        bool lost = false;                   ///< it does not fit, and is not `held`
        bool pushed = false;                 ///< result of wasPushed()
    };
    /// Registers @p live. If that is impossible, returns the doubt: too few points to begin a map, or the
    /// robot's pose is unknown.
    [[nodiscard]] std::variant<Registered, ScanDoubt> registered(const LiveScan& live,
                                                                 const RobotTrack& robot,
                                                                 std::span<const PlacedBody> others);
    /// Returns whether @p found becomes a key scan. Sets RobotTrack::waited of @p robot: whether the scan is
    /// left out so that the next one enters.
    [[nodiscard]] bool isKeyScan(RobotTrack& robot, const LiveScan& live, const Registered& found) const;
    /// Enters @p found into the map. Adds to @p update what shall be logged.
    void enter(MapUpdate& update, RobotTrack& robot, const LiveScan& live, const Registered& found, Time now);
    /// Updates wheels, scanner and pose of @p robot from @p found.
    void advance(RobotTrack& robot, const LiveScan& live, const Registered& found) const;
    /// Makes links from the newest key scan to the scans @p against that it was matched with, and looks for a
    /// loop there.
    void link(MapUpdate& update, const RobotTrack& robot, std::span<const std::uint64_t> against,
              const Match& match, Time now);
    [[nodiscard]] bool enters(const RobotTrack& robot, const Pose& scanInMap, double fresh) const;
    /// Returns whether the map can do without the scan at @p scanInMap, if the next scan enters.
    [[nodiscard]] bool canWait(const RobotTrack& robot, const Pose& scanInMap, double fresh) const;
    /// Returns the pose of a scan that begins a new part, aside from the map. @p up: upward direction in the
    /// scan's frame.
    [[nodiscard]] Pose aside(const Eigen::Vector3d& up) const;
    /// Returns whether all scans in the part of @p robot are uncertain or set aside. False if the operator
    /// has placed the robot, or if it has no key scan.
    [[nodiscard]] bool isAlone(const RobotTrack& robot);
    /// Returns whether the next scan of @p robot begins a new part beside existing ones, if it is complete
    /// enough. Also true if all scans of its present part were set aside.
    [[nodiscard]] bool beginsPart(const RobotTrack& robot);
    /// Returns the part of the map to which the next scan of @p robot will belong. The scan is expected
    /// around @p guess.
    [[nodiscard]] std::uint64_t partFor(const RobotTrack& robot, const Pose& guess);
    /// Returns the settings for preparing the next scan of @p robot, which is expected around @p guess.
    [[nodiscard]] const LiveSettings& preparing(const RobotTrack& robot, const Pose& guess);

    GrowingMap& m_map;
};

}  // namespace leitstand
