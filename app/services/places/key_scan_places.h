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

/// The poses of a mission's key scans by its events, and the places of its robots by these. What is seen is
/// attached to a key scan, so that it moves with the map. Has no thread; one call at a time.
class KeyScanPlaces {
public:
    /// Whether @p event concerns the places of key scans or robots.
    [[nodiscard]] static bool wants(const Event& event);
    /// Takes all events of a mission that wants() accepts, in order. Returns the places of robots that @p
    /// event shows.
    [[nodiscard]] std::vector<PlaceOfRobot> onEvent(const Event& event);
    /// Sets the poses of key scans: at first those of earlier sessions, after an undo those of all. Key scans
    /// that are not in @p poses no longer count. Returns the places of robots that the poses show.
    [[nodiscard]] std::vector<PlaceOfRobot> follow(std::span<const ScanPose> poses);

    /// Returns the key scan to which something is attached that @p robot saw from @p place in the map [m]. It
    /// is the newest one of the robot if that counts, else the nearest one that counts; 0: none.
    [[nodiscard]] std::uint64_t scanFor(const std::string& robot, const Eigen::Vector3d& place) const;
    [[nodiscard]] const Pose& scanInMap(std::uint64_t scan) const { return m_scans.at(scan).scanInMap; }

private:
    struct Scan {
        std::string robot;  ///< empty: of an earlier session
        Time end{};         ///< robot's clock
        Pose sensorInBase = Pose::Identity(), scanInMap = Pose::Identity();
        bool counts = true;

        [[nodiscard]] PlaceOfRobot fix(double certainty) const;
    };
    void move(const ScanPose& pose, std::vector<PlaceOfRobot>& fixes);

    std::map<std::uint64_t, Scan> m_scans;
    std::map<std::string, std::uint64_t> m_newest;  ///< key scan of each robot
};

}  // namespace leitstand
