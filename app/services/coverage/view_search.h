#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "app/services/coverage/view_finder.h"
#include "app/services/places/key_scan_places.h"
#include "core/event/scan_pose.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct Event;

/// Finds where the cameras of all robots looked from, and attaches each view to a key scan. Events are enough
/// to follow the map, so that it works on a log as it does live. Has no thread; one call at a time.
class ViewSearch {
public:
    explicit ViewSearch(const std::vector<RobotDescription>& robots);

    /// Whether a search uses @p event at all.
    [[nodiscard]] static bool wants(const Event& event);
    /// Takes all events of a mission, in order.
    void onEvent(const Event& event);
    /// Sets the poses of key scans: at first those of earlier sessions, after an undo those of all. Key scans
    /// that are not in @p poses no longer count.
    void follow(std::span<const ScanPose> poses);
    /// Sets where @p robot was. A live station calls this for every scan that fits, which is more often than
    /// key scans show it.
    void correct(const std::string& robot, const MapFix& fix);
    void lose(const std::string& robot);  ///< the robot is no longer in the map
    /// Views found since the last call.
    [[nodiscard]] std::vector<SearchView> found();

private:
    void correct(std::span<const PlaceOfRobot> fixes);

    std::map<std::string, ViewFinder> m_finders;  ///< the set is fixed
    KeyScanPlaces m_scans;
    std::vector<SearchView> m_found;
};

}  // namespace leitstand
