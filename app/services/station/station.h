#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/services/domain/robot_guess.h"
#include "app/services/log/live_mission.h"
#include "core/base/result.h"
#include "core/event/station_samples.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/map.h"
#include "core/robot/control/drive_setpoint.h"
#include "core/robot/link/wire_complaint.h"
#include "core/settings/domain_settings.h"
#include "core/station/robot_view.h"

namespace leitstand {

struct PoseSample;
struct Event;
struct SearchedFloor;
class FindDesk;
class StationAlarms;
class StationBrakes;
class StationCameras;
class StationGuards;
class StationStreams;

/// Settings of a station in a domain.
struct StationSettings {
    DomainSettings domain = {};
    /// How everything is recorded. Its robots are those of the station; its field `station` is set from
    /// `memory`.
    LiveMissionSettings mission = {};
    std::filesystem::path memory;  ///< file of the station's identity and grants (StationFile)
    std::filesystem::path alarms;  ///< file of AlarmLimits; empty, or no such file: the usual ones
    LiveSettings mapping = {};     ///< for the registration by the station that holds the map's grant
};

/// Receives what happens; any function may be empty. Called on threads of the station, which the functions
/// must not block. They may call functions of the station, but must not destroy it.
struct StationListener {
    std::function<void(const std::string&)> onMessage = {};  ///< for the operator, in words
    std::function<void(const Event&)> onEvent = {};          ///< as of LiveMission
    std::function<void(const MapPtr&)> onMap = {};           ///< the map has grown or moved
    std::function<void(const LiveMapPtr&)> onScans =
        {};  ///< key scans of the map have changed, or whether they count
};

class StationClock;
class StationMapping;

/// An operator's station on live robots (docs/design.md, "A mission is its log" and "The wire"): records
/// everything, watches links, holds grants, drives one robot at a time, stops all. Any thread; no call waits
/// for network or disk.
class Station {
public:
    /// Joins the domain and opens the mission. Errors name the obstacle: network card, identity, folder,
    /// robot's topic.
    [[nodiscard]] static Result<std::unique_ptr<Station>> open(const StationSettings& settings,
                                                               StationListener listener = {});
    ~Station();  ///< robots stand, grants are released but remembered, the mission is self-contained
    Station(const Station&) = delete;
    Station& operator=(const Station&) = delete;

    [[nodiscard]] const std::vector<RobotDescription>& robots() const;
    /// Returns the view of a robot; an empty one for an unknown name. It lacks the surroundings, which take
    /// longest: surroundings() returns them.
    [[nodiscard]] RobotView robot(const std::string& name) const;
    /// Returns the surroundings of @p robot now, for RobotView::around; empty: not known.
    [[nodiscard]] std::optional<VirtualScanView> surroundings(const std::string& robot) const;
    /// Returns when a scan of @p robot came last, since when surroundings() returns something else; empty:
    /// never.
    [[nodiscard]] std::optional<SteadyTime> scanned(const std::string& robot) const;
    [[nodiscard]] MissionStatePtr mission() const;
    [[nodiscard]] LiveMissionStatus log() const;
    [[nodiscard]] const std::filesystem::path& folder() const;  ///< of the mission
    [[nodiscard]] StationMapping& mapping();  ///< the map, and the operator's decisions on its scans
    [[nodiscard]] StationClock& clock();      ///< of the mission
    /// Sets what reports contain about the mission; fills in time and sender.
    Result<void> describe(MissionInfoSample info);
    [[nodiscard]] FindDesk& finds();  ///< files victims and other finds
    /// What was searched with each kind of sensor; null until there is a map.
    [[nodiscard]] std::shared_ptr<const SearchedFloor> searched() const;
    [[nodiscard]] StationAlarms& alarms();                        ///< what the operator has to know
    [[nodiscard]] std::vector<WireComplaint> mismatches() const;  ///< between robots and us
    /// Returns warnings in words: limits of this computer, such as those that cost samples. Empty: all is
    /// well.
    [[nodiscard]] std::vector<std::string> limits() const;
    [[nodiscard]] std::vector<SeenTopic> visibleTopics() const;  ///< what others publish and subscribe to
    [[nodiscard]] const StationSettings& settings() const;       ///< with which it was opened

    /// Gives the sticks to one robot; all others stand. Empty: to none.
    void setDriveFocus(const std::string& robot);
    /// Sets the sticks as they are now, also when neutral; call it at least ten times a second. The speed is
    /// capped by the age of what the driver sees (SightCap), wherever the sticks come from, except while
    /// @p withoutEyes is set.
    void setStick(const DriveVelocity& sticks, bool withoutEyes = false);
    /// Stops the robot that has the sticks, until the sticks were neutral. If it drives itself, requests that
    /// it obeys them again.
    void halt();
    /// Sets the camera through which the driver of @p robot looks to @p sensor; at first, it is the robot's
    /// first camera.
    void selectCamera(const std::string& robot, const std::string& sensor);

    void requestGrant(const std::string& robot);                 ///< requests the grant to drive
    void releaseGrant(const std::string& robot);                 ///< releases the grant
    void answerRequest(const std::string& robot, bool consent);  ///< answers a request for a grant of ours

    /// Returns which station makes the map, and which one requests it.
    [[nodiscard]] GrantView mapGrant() const;
    void giveMap();  ///< to the station that requested it first; nothing if none did
    void stopAll();
    void stop(const std::string& robot);
    Result<void> release(const std::string& robot);  ///< as of StopSender

    /// Requests @p mode of a robot; fills in time and sender. Errors: the robot takes no modes; those of
    /// maySend(), except for modes of teleoperation.
    Result<void> setMode(const std::string& robot, const std::string& mode);
    /// Error when @p robot may not be sent anywhere: during its brake test, or while drive commands are
    /// refused after it.
    [[nodiscard]] Result<void> maySend(const std::string& robot) const;
    /// Sends @p robot to @p goal. Errors also as of maySend().
    Result<void> goTo(const std::string& robot, const PoseSample& goal);
    [[nodiscard]] StationBrakes& brakes();    ///< tests of what robots do when commands end
    [[nodiscard]] StationGuards& guards();    ///< of robots that drive on when commands end
    [[nodiscard]] StationStreams& streams();  ///< rates and qualities of what robots send; the thin link
    [[nodiscard]] StationCameras& cameras();

private:
    struct State;
    explicit Station(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
