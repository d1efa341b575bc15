#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/event/event.h"
#include "core/mapping/live/robot_tracker.h"

namespace leitstand {

/// Where one robot was.
struct PlaceOfRobot {
    std::string robot;
    MapFix fix;
};

/// Where a mission's key scans are, as its events tell, and what that tells of its robots; what is seen hangs
/// on a scan, so that it moves with the map. Without thread; one at a time.
class KeyScanPlaces {
public:
    /// Whether @p event says something of key scans' or robots' places.
    [[nodiscard]] static bool wants(const Event& event);
    /// All events of a mission that it wants, in order. Tells where robots were by them.
    [[nodiscard]] std::vector<PlaceOfRobot> onEvent(const Event& event);
    /// Where all scans are: of earlier sessions, or after an undo. Those that are not named do not count.
    [[nodiscard]] std::vector<PlaceOfRobot> follow(std::span<const ScanPose> poses);

    /// The scan that something hangs on which @p robot saw from @p place: its newest one, where that counts,
    /// else the nearest that does; 0: there is none.
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
