#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/event/scan_pose.h"
#include "core/mapping/live/robot_tracker.h"

namespace leitstand {

struct Event;

/// Where one robot was.
struct PlaceOfRobot {
    std::string robot;
    MapFix fix;
};

/// Follows the poses of a mission's key scans from its events, and finds the places of its robots from these
/// poses. What robots see is attached to a key scan, so that it moves with the map. It has no thread; one
/// call at a time.
class KeyScanPlaces {
public:
    /// Whether @p event is about the places of key scans or robots.
    [[nodiscard]] static bool wants(const Event& event);
    /// Call with all events of a mission that wants() accepts, in order. Returns the places of robots that
    /// @p event shows.
    [[nodiscard]] std::vector<PlaceOfRobot> onEvent(const Event& event);
    /// Sets the poses of key scans: first those of earlier sessions, after an undo those of all. Key scans
    /// that are not in @p poses are no longer used. Returns the places of robots that the poses show.
    [[nodiscard]] std::vector<PlaceOfRobot> follow(std::span<const ScanPose> poses);

    /// Returns the key scan to which something at @p place (in the map [m]) is attached that @p robot saw.
    /// This is the robot's newest key scan if it is certain, otherwise the nearest certain one; 0: none.
    [[nodiscard]] std::uint64_t scanFor(const std::string& robot, const Eigen::Vector3d& place) const;
    [[nodiscard]] const Pose& scanInMap(std::uint64_t scan) const { return m_scans.at(scan).scanInMap; }

private:
    struct Scan {
        std::string robot;  ///< empty: from an earlier session
        Time end{};         ///< end of the scan, robot's clock
        Pose sensorInBase = Pose::Identity(), scanInMap = Pose::Identity();
        bool counts = true;

        [[nodiscard]] PlaceOfRobot fix(double certainty) const;
    };
    void move(const ScanPose& pose, std::vector<PlaceOfRobot>& fixes);

    std::map<std::uint64_t, Scan> m_scans;
    std::map<std::string, std::uint64_t> m_newest;  ///< newest key scan of each robot
};

}  // namespace leitstand
