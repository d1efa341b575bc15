#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/services/domain/domain_settings.h"
#include "app/services/domain/robot_guess.h"
#include "app/services/log/live_mission.h"
#include "core/base/result.h"
#include "core/event/event.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/map.h"
#include "core/robot/control/drive_setpoint.h"
#include "core/robot/link/wire_complaint.h"
#include "core/station/robot_view.h"

namespace leitstand {

struct SearchedFloor;
class FindDesk;
class StationAlarms;
class StationBrakes;
class StationCameras;
class StationGuards;
class StationStreams;

/// A station in a domain.
struct StationSettings {
    DomainSettings domain = {};
    /// Where everything is recorded; its robots are those of the station. Its station is set from the memory.
    LiveMissionSettings mission = {};
    std::filesystem::path memory;  ///< file of the station's identity and grants (StationFile)
    std::filesystem::path alarms;  ///< file of AlarmLimits; empty, or none there: the usual ones
    LiveSettings mapping = {};     ///< how the station that holds the map's grant registers
};

/// Who is told what happens. Called on threads of the station's, which they must not hold up; any may be
/// empty. May call the station's functions, but not destroy it.
struct StationListener {
    std::function<void(const std::string&)> onMessage = {};  ///< for the operator, in words
    std::function<void(const Event&)> onEvent = {};          ///< as of LiveMission
    std::function<void(const MapPtr&)> onMap = {};           ///< the map has grown or moved
    std::function<void(const LiveMapPtr&)> onScans = {};     ///< likewise: its scans, and how far they count
};

class StationClock;
class StationMapping;

/// An operator's station on live robots (design, sections 1 and 4): records everything, watches links, holds
/// grants, drives one robot at a time, stops all. Any thread; nothing waits for network or disk.
class Station {
public:
    /// Joins the domain and opens the mission. Errors name what is in the way: network card, identity,
    /// folder, robot's topic.
    [[nodiscard]] static Result<std::unique_ptr<Station>> open(const StationSettings& settings,
                                                               StationListener listener = {});
    ~Station();  ///< robots stand, grants are given up but remembered, the mission is self-contained
    Station(const Station&) = delete;
    Station& operator=(const Station&) = delete;

    [[nodiscard]] const std::vector<RobotDescription>& robots() const;
    /// Of an unknown name: nothing. What is around is asked for apart, since it takes longest.
    [[nodiscard]] RobotView robot(const std::string& name) const;
    /// What is around it now: RobotView::around.
    [[nodiscard]] std::optional<VirtualScanView> around(const std::string& robot) const;
    /// When anything of its scans came last, after which what is around it looks otherwise; none: never.
    [[nodiscard]] std::optional<SteadyTime> scanned(const std::string& robot) const;
    [[nodiscard]] MissionStatePtr mission() const;
    [[nodiscard]] LiveMissionStatus log() const;
    [[nodiscard]] const std::filesystem::path& folder() const;  ///< of the mission
    [[nodiscard]] StationMapping& mapping();  ///< the map, and the operator's decisions on its scans
    [[nodiscard]] StationClock& clock();      ///< of the mission
    /// What the report says of the mission; time and sender are filled in.
    Result<void> describe(MissionInfoSample info);
    [[nodiscard]] FindDesk& finds();  ///< files victims and other finds
    /// What was searched with each kind of sensor; null until there is a map.
    [[nodiscard]] std::shared_ptr<const SearchedFloor> searched() const;
    [[nodiscard]] StationAlarms& alarms();                        ///< what the operator has to know
    [[nodiscard]] std::vector<WireComplaint> mismatches() const;  ///< between robots and us
    [[nodiscard]] std::vector<std::string> limits() const;        ///< of this computer, that cost samples
    [[nodiscard]] std::vector<SeenTopic> heard() const;           ///< what others say and hear in the domain
    [[nodiscard]] const StationSettings& settings() const;        ///< as it was opened

    /// Gives the sticks to one robot: all others stand. Empty: to none.
    void focus(const std::string& robot);
    /// The sticks as they are now, also when neutral; to be told at least ten times a second.
    /// However they came, the speed is capped by the age of what the driver sees (SightCap), but while
    /// @p withoutEyes is told with them.
    void push(const DriveVelocity& sticks, bool withoutEyes = false);
    /// The robot that has the sticks stands until they were neutral; one that drives itself is asked to obey
    /// them again.
    void halt();
    /// The driver looks at @p robot's surroundings through its camera @p sensor; at first, through its first.
    void lookThrough(const std::string& robot, const std::string& sensor);

    void ask(const std::string& robot);                   ///< for the grant to drive
    void giveUp(const std::string& robot);                ///< the grant
    void answer(const std::string& robot, bool consent);  ///< to who asks for a grant of ours

    /// Who makes the map; who else would.
    [[nodiscard]] GrantView mapGrant() const;
    void giveMap();  ///< to the station that asked for it first; nothing while none did
    void stopAll();
    void stop(const std::string& robot);
    Result<void> release(const std::string& robot);  ///< as of StopSender

    /// Wishes to a robot; its own time and sender are filled in. Errors: it takes none of that kind; and
    /// those of maySend(), but for modes of teleoperation.
    Result<void> setMode(const std::string& robot, const std::string& mode);
    /// Whether @p robot may be sent anywhere: not while drive commands are refused for its brakes.
    [[nodiscard]] Result<void> maySend(const std::string& robot) const;
    /// Errors also as of maySend().
    Result<void> goTo(const std::string& robot, const PoseSample& goal);
    [[nodiscard]] StationBrakes& brakes();    ///< tests of what robots do without commands
    [[nodiscard]] StationGuards& guards();    ///< of robots that go on without commands
    [[nodiscard]] StationStreams& streams();  ///< rates and qualities of what robots send; the thin link
    [[nodiscard]] StationCameras& cameras();

private:
    struct State;
    explicit Station(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
