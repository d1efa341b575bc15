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

/// Follows where the cameras of all robots look from, and attaches each view to a key scan. All that it knows
/// of the map is also in events, so it works on a log as it does live. Has no thread; one call at a time.
class ViewSearch {
public:
    explicit ViewSearch(const std::vector<RobotDescription>& robots);

    /// Whether a search uses @p event at all.
    [[nodiscard]] static bool wants(const Event& event);
    /// Takes all events of a mission, in order.
    void onEvent(const Event& event);
    /// Sets where key scans are: those of earlier sessions, or all after an undo.
    void follow(std::span<const ScanPose> poses);
    /// Sets where @p robot was, from every scan that fits: live, this is more than key scans show.
    void correct(const std::string& robot, const MapFix& fix);
    void lose(const std::string& robot);  ///< it is no longer in the map
    /// Views found since the last call.
    [[nodiscard]] std::vector<SearchView> found();

private:
    void correct(std::span<const PlaceOfRobot> fixes);

    std::map<std::string, ViewFinder> m_finders;  ///< the set is fixed
    KeyScanPlaces m_scans;
    std::vector<SearchView> m_found;
};

}  // namespace leitstand
