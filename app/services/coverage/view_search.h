#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "app/services/coverage/view_finder.h"
#include "app/services/places/key_scan_places.h"
#include "core/event/event.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Follows where the cameras of all robots look from, and hangs every view on a key scan. All that it knows
/// of the map is in events too, so it does on a log what it does live. Without thread; one at a time.
class ViewSearch {
public:
    explicit ViewSearch(const std::vector<RobotDescription>& robots);

    /// Whether a search wants to know of @p event at all.
    [[nodiscard]] static bool wants(const Event& event);
    /// All events of a mission, in order.
    void onEvent(const Event& event);
    /// Where key scans are: of earlier sessions, or after an undo.
    void follow(std::span<const ScanPose> poses);
    /// Where @p robot was, by every scan that fits: live, more than the key scans tell.
    void correct(const std::string& robot, const MapFix& fix);
    void lose(const std::string& robot);  ///< it is not in the map any more
    /// Views that came since the last call.
    [[nodiscard]] std::vector<SearchView> found();

private:
    void correct(std::span<const PlaceOfRobot> fixes);

    std::map<std::string, ViewFinder> m_finders;  ///< fixed
    KeyScanPlaces m_scans;
    std::vector<SearchView> m_found;
};

}  // namespace leitstand
