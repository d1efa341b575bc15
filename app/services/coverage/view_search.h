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

/// Finds from where the cameras of all robots looked, and attaches each view to a key scan. Events are
/// sufficient to follow the map, so it works on a log as it does live. It has no thread; one call at a time.
class ViewSearch {
public:
    explicit ViewSearch(const std::vector<RobotDescription>& robots);

    /// Whether a search uses events like @p event.
    [[nodiscard]] static bool wants(const Event& event);
    /// Call with all events of a mission, in order.
    void onEvent(const Event& event);
    /// Sets the poses of key scans: first those of earlier sessions, after an undo those of all. Key scans
    /// that are not in @p poses are no longer used.
    void follow(std::span<const ScanPose> poses);
    /// Sets where @p robot was. A live station calls this for every scan that fits. That is more often than
    /// there are key scans.
    void correct(const std::string& robot, const MapFix& fix);
    void lose(const std::string& robot);  ///< call when the robot is no longer in the map
    /// Views found since the last call.
    [[nodiscard]] std::vector<SearchView> found();

private:
    void correct(std::span<const PlaceOfRobot> fixes);

    std::map<std::string, ViewFinder> m_finders;  ///< robots are never added or removed
    KeyScanPlaces m_scans;
    std::vector<SearchView> m_found;
};

}  // namespace leitstand
