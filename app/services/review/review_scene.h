#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/services/mapping/robot_sight.h"
#include "app/services/recorded/review_index.h"
#include "app/services/recorded/review_log.h"
#include "core/mapping/live/map/cropped_scans.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/robot_in_map.h"
#include "core/mapping/map.h"
#include "core/mission/state/mission_state.h"
#include "core/station/alarms/alarm.h"
#include "core/station/robot_view.h"

namespace leitstand {

/// The map that a review shows.
enum class ReviewMap : std::uint8_t {
    AsThen,    ///< the scans and poses that the station had at that moment
    Finished,  ///< the map at the end of the mission, with all corrections
};

/// A moment of a mission as all panes show it. Immutable once shared.
struct ReviewMoment {
    Time now{};  ///< time of the moment, station's clock
    MissionStatePtr mission;
    std::map<std::string, RobotView>
        robots;             ///< by name; only the watched one has surroundings, cameras and joints
    RobotsInMapPtr places;  ///< never null
    LiveMapPtr scans;       ///< never null; the same object as long as nothing changed
    MapPtr map;             ///< never null; the same object as long as nothing changed
    std::vector<Alarm> alarms;
    std::vector<Event> pictures;  ///< newest picture and calibration of each of the watched robot's cameras
};
using ReviewMomentPtr = std::shared_ptr<const ReviewMoment>;

/// Makes moments of a mission. One thread at a time.
class ReviewScene {
public:
    /// @p log and @p index must outlive this object.
    ReviewScene(ReviewLog& log, const ReviewIndex& index);

    /// Sets the robot whose surroundings and pictures are shown; at first, the first robot.
    void watch(const std::string& robot);
    void show(ReviewMap map) { m_which = map; }
    /// Returns the mission at @p at. If @p around is false, two things are kept from the last moment: the
    /// surroundings of the watched robot, which take longest, and the rates of streams.
    [[nodiscard]] ReviewMomentPtr at(Time at, bool around = true);

private:
    void look(Time at);
    void beginSight(const RobotDescription& robot, Time from);
    void see(const Event& event);  ///< takes an event of the watched robot
    void countStreams(const MissionState& state, Time at);
    void showMap(const MissionState& state);
    [[nodiscard]] RobotInMap place(const RobotDescription& robot, const MissionState& state, Time at) const;
    [[nodiscard]] std::vector<Event> pictures(Time at);
    [[nodiscard]] const RobotDescription* watched() const;

    ReviewLog& m_log;
    const ReviewIndex& m_index;
    std::string m_watched;
    ReviewMap m_which = ReviewMap::AsThen;
    std::unique_ptr<RobotSight> m_sight;  ///< sight of the watched robot
    bool m_scanned = false;               ///< whether the log has what the watched robot's scanners sent
    Time m_seen{};                        ///< time of the newest event in m_sight
    std::optional<VirtualScanView> m_around;
    std::map<std::string, std::vector<StreamStatus>> m_streams;  ///< by robot
    CroppedScans m_cropped;
    MissionState m_mapped;  ///< state whose scans are shown by m_scans and m_map
    LiveMapPtr m_scans;
    MapPtr m_map;
};

}  // namespace leitstand
