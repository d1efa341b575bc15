#pragma once

#include <map>
#include <optional>
#include <string>

#include "app/services/mapping/robots/mapped_robots.h"
#include "core/event/map_samples.h"

namespace leitstand {

/// Places robots in the map. Those that do not make it are placed by their lasers, beside the robot that
/// does, or where its scans show them. Any robot is placed where the operator puts it. One whose place stays
/// unknown begins a part of its own. On the mapping's thread.
class RobotPlacing {
public:
    RobotPlacing(MappingContext& context, MappedRobots& robots) : m_context(context), m_robots(robots) {}

    /// Takes what the laser of robot @p name sees.
    void seeing(const std::string& name, MappedRobot& robot, LaserView view, Time now);
    void placeOthers(Time now);  ///< places robots that do not make the map, beside the one that does
    /// ... where the scan of @p update shows them; @p before: the map without it.
    void placeSeen(const MapUpdate& update, const LiveMapPtr& before, Time now);
    /// Places @p robot, which took @p scan, unless its scans are in the map. After some scans without a place
    /// it begins a part of its own.
    void place(MappedRobot& robot, const LiveScan& scan, Time now);
    /// Sets robot @p name to @p baseInMap, for the operator.
    void put(const std::string& name, const Pose& baseInMap);
    /// Takes where another station, which makes the map, has a robot.
    void follow(const RobotPlaceSample& place);
    void publish(const std::optional<RobotPlaceSample>& place) const;  ///< to the listener

private:
    void placeBeside(const std::string& name, MappedRobot& robot, Time now);
    /// Returns the first key scan of a robot of ours. Without one, returns the first of the map, which was
    /// carried here. Null: no map.
    [[nodiscard]] const LiveKeyScan* firstOfOurs() const;

    MappingContext& m_context;
    MappedRobots& m_robots;
    std::map<std::string, int> m_unplaced;  ///< 3D scans of robots while their places were unknown, by name
};

}  // namespace leitstand
