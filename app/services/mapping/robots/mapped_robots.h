#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/services/places/sensor_poses.h"
#include "core/mapping/live/live_mapper.h"
#include "core/mapping/live/robot_in_map.h"
#include "core/mapping/live/robot_tracker.h"
#include "core/mapping/motion/mapping_scanner.h"
#include "core/mapping/motion/scan_cutter.h"
#include "core/mapping/placement/laser_robot.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct CloudSample;
struct Event;
struct MappingContext;

/// A scan as received, and as it would enter the map.
struct SeenScan {
    LiveScan live;
    ScanPtr ready;
};

/// A robot whose scans are mapped.
struct MappedRobot {
    MappedRobot(const RobotDescription& description, const std::string& station);
    SensorPoses poses;
    std::map<std::string, ScanCutter> cutters;  ///< cutters by topic of the scanner
    RobotTracker tracker;
    LaserRobot laser;                        ///< corrects the tracker as long as no 3D scan of the robot does
    std::chrono::nanoseconds ahead{};        ///< how far its clock is ahead of the station's
    std::optional<Time> matched;             ///< RobotInMap::matched
    std::optional<RobotFix> followed;        ///< fix that last corrected the tracker
    std::shared_ptr<const SeenScan> newest;  ///< its newest scan that has enough points
    MappingScanner mapping;                  ///< which of its scanners makes the map
    std::string scanner;                     ///< sensor of that scanner; empty: not known yet, or none
    std::string planeLaser;                  ///< planeLaserOf() it
    std::optional<Time> planeSince;          ///< when the first turn of that laser was received
    bool mapsByPlane = false;                ///< whether that laser makes the map
    bool sendsClouds = false;                ///< whether a cloud was received
};

/// The robots of LiveMapping: how they move, and where they are. On the mapping's thread, unless a function
/// says otherwise.
class MappedRobots {
public:
    /// Called with a turn of the plane laser of the robot @p name.
    using SeesByLaser = std::function<void(const std::string& name, MappedRobot&, LaserView, Time now)>;
    MappedRobots(MappingContext& context, const std::vector<RobotDescription>& robots,
                 const std::string& station, SeesByLaser sees);

    /// Takes odometry, inertial unit, fixed frames, 3D scans, turns of a plane laser, and clock offsets. Only
    /// for events for which isOfOurs() is true.
    void add(const Event& event);
    /// Makes the map with the scanner of @p robot whose clouds are on @p topic. The robot must be one of this
    /// station's.
    void mapWith(const std::string& robot, const std::string& topic);
    /// Whether @p event is from one of this station's robots, and add() takes it; any thread.
    [[nodiscard]] bool isOfOurs(const Event& event) const;
    /// Returns when slices of a scanner must be processed at the latest, even if no event arrives; station's
    /// clock. Empty: none waits.
    [[nodiscard]] std::optional<Time> due() const;

    [[nodiscard]] const std::vector<RobotDescription>& descriptions() const { return m_descriptions; }
    /// Robots are never added or removed.
    [[nodiscard]] std::map<std::string, MappedRobot>& byName() { return m_robots; }
    [[nodiscard]] MappedRobot& at(const std::string& name) { return m_robots.at(name); }
    [[nodiscard]] bool contains(const std::string& name) const { return m_robots.contains(name); }
    /// Returns where robots other than @p robot stand. @p certain: only those whose places are certain.
    [[nodiscard]] std::vector<Disc> othersThan(const MappedRobot& robot, bool certain) const;

    void followFixes();  ///< moves robots to where the mapper says they are
    void layTrails();    ///< moves trails after decisions moved the scans
    void carryAlong();   ///< moves robots without scans in the map together with the scans around them
    /// Notes that a 3D scan of @p name was received, which another station registers; any thread.
    void scanReceived(const std::string& name, Time received);
    void matched(const std::string& name, Time now);  ///< call when a scan of the robot was registered here
    void matchedElsewhere();  ///< call when another station begins to register the robots' scans
    void publish();           ///< updates inMap()
    /// Where the robots are; never null after publish(). Any thread.
    [[nodiscard]] RobotsInMapPtr inMap() const;

private:
    /// Returns whether @p cloud of @p event is of the scanner that makes the map of @p robot. Decides which
    /// one it is once enough was received.
    [[nodiscard]] bool isOfMap(MappedRobot& robot, const Event& event, const CloudSample& cloud);
    /// Returns whether turns of the plane laser that sent @p event make the map. They do not where there are
    /// 3D scanners: their map shows more, and the laser finds its robot in it. A scanner that a file names is
    /// waited for before the laser begins.
    [[nodiscard]] bool mapsByPlane(MappedRobot& robot, const Event& event);
    /// Returns the same as long as it is not decided.
    [[nodiscard]] bool beginsByPlane(const MappedRobot& robot, const Event& event) const;
    MappingContext& m_context;
    const std::vector<RobotDescription> m_descriptions;
    const SeesByLaser m_sees;
    std::map<std::string, MappedRobot> m_robots;
    std::set<std::string>
        m_scanners;  ///< robots with a 3D scanner that were heard; not those that map by laser
    mutable std::mutex m_mutex;
    RobotsInMapPtr m_places;  ///< under the mutex
    /// Under the mutex: times of the newest scans that other stations register.
    std::map<std::string, Time> m_received;
};

/// Whether scans of @p before have other poses in @p after, or have since been set aside or accepted again.
/// False if @p before is null.
[[nodiscard]] bool scansMoved(const LiveMapPtr& before, const LiveMap& after);

}  // namespace leitstand
