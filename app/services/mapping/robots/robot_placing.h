#pragma once

#include <map>
#include <optional>
#include <string>

#include "app/services/mapping/robots/mapped_robots.h"
#include "core/event/map_samples.h"

namespace leitstand {

/// Places robots in the map. A robot without scans in the map is placed by its laser: beside the robot that
/// makes the map, or where that robot's scans show it. Any robot is placed where the operator says. If its
/// place remains unknown, a robot begins a new part of the map. On the mapping's thread.
class RobotPlacing {
public:
    RobotPlacing(MappingContext& context, MappedRobots& robots) : m_context(context), m_robots(robots) {}

    /// Takes what the laser of the robot @p name sees.
    void seeing(const std::string& name, MappedRobot& robot, LaserView view, Time now);
    void placeOthers(Time now);  ///< places robots without scans in the map, beside the robot that makes it
    /// Places robots without scans in the map where the scan of @p update shows them. @p before: the map
    /// without that scan.
    void placeSeen(const MapUpdate& update, const LiveMapPtr& before, Time now);
    /// Places @p robot, which took @p scan, unless its scans are in the map. If some scans have found no
    /// place, the robot begins a new part of the map.
    void place(MappedRobot& robot, const LiveScan& scan, Time now);
    /// Places the robot @p name at @p baseInMap, as the operator says.
    void put(const std::string& name, const Pose& baseInMap);
    /// Takes a robot's place from another station, which makes the map.
    void follow(const RobotPlaceSample& place);
    void publish(const std::optional<RobotPlaceSample>& place) const;  ///< passes @p place to the listener

private:
    void placeBeside(const std::string& name, MappedRobot& robot, Time now);
    /// Returns the first key scan of one of this station's robots. If there is none, returns the first key
    /// scan of the map, which came from another mission. Null: no map.
    [[nodiscard]] const LiveKeyScan* firstOfOurs() const;

    /// What a robot scanned while its place was unknown.
    struct Waits {
        int scans = 0;
        Time since{};  ///< of the first one; robot's clock
    };
    MappingContext& m_context;
    MappedRobots& m_robots;
    std::map<std::string, Waits> m_unplaced;  ///< by robot
};

}  // namespace leitstand
