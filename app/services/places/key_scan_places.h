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

/// Where a mission's key scans are, by its events, and where its robots were by them. What is seen is
/// attached to a scan, so that it moves with the map. Has no thread; one call at a time.
class KeyScanPlaces {
public:
    /// Whether @p event concerns the places of key scans or robots.
    [[nodiscard]] static bool wants(const Event& event);
    /// Takes all events of a mission that it wants, in order. Returns where robots were by them.
    [[nodiscard]] std::vector<PlaceOfRobot> onEvent(const Event& event);
    /// Sets where all scans are: those of earlier sessions, or all after an undo. Scans that are not named do
    /// not count. Returns where robots were by them.
    [[nodiscard]] std::vector<PlaceOfRobot> follow(std::span<const ScanPose> poses);

    /// Returns the scan to attach something to that @p robot saw from @p place: its newest one if that
    /// counts, else the nearest that does; 0: none.
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
