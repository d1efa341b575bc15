#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/services/domain/seen_topic.h"
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
class JointMoving;
class StationCameras;
class StationGuards;
class StationStreams;
class FrameWatch;
class TopicWatch;

/// Settings of a station in a domain.
struct StationSettings {
    DomainSettings domain = {};
    /// How everything is recorded. Its robots are the station's robots; its field `station` is set from
    /// `memory`.
    LiveMissionSettings mission = {};
    std::filesystem::path memory;  ///< file of the station's identity and grants (StationFile)
    std::filesystem::path alarms;  ///< file of AlarmLimits; if empty or missing: the usual limits
    LiveSettings mapping = {};  ///< settings for registration, used while this station holds the map's grant
};

/// Called with what happens; each function may be empty. Called on threads of the station, which must not be
/// blocked. The functions may call functions of the station, but must not destroy it.
struct StationListener {
    std::function<void(const std::string&)> onMessage = {};  ///< called with a text for the operator
    std::function<void(const Event&)> onEvent = {};          ///< as LiveMissionListener::onEvent
    std::function<void(const MapPtr&)> onMap = {};           ///< called when the map grew or moved
    std::function<void(const LiveMapPtr&)> onScans =
        {};  ///< called when key scans of the map, or their trust, changed
};

class StationClock;
class StationMapping;

/// An operator's station with live robots (docs/design.md, "A mission is its log" and "The wire"): records
/// everything, monitors links, holds grants, drives one robot at a time, stops all robots. Any thread; no
/// call waits for network or disk.
class Station {
public:
    /// Joins the domain and opens the mission. Errors say what prevents it: network card, identity, folder, a
    /// robot's topic.
    [[nodiscard]] static Result<std::unique_ptr<Station>> open(const StationSettings& settings,
                                                               StationListener listener = {});
    ~Station();  ///< makes robots stand, releases grants but remembers them, and completes the mission
    Station(const Station&) = delete;
    Station& operator=(const Station&) = delete;

    [[nodiscard]] const std::vector<RobotDescription>& robots() const;
    /// Returns the view of a robot; an empty view for an unknown name. It lacks the surroundings, which take
    /// longest; surroundings() returns them.
    [[nodiscard]] RobotView robot(const std::string& name) const;
    /// Returns the present surroundings of @p robot, for RobotView::around; empty: not known.
    [[nodiscard]] std::optional<VirtualScanView> surroundings(const std::string& robot) const;
    /// Returns when the last scan of @p robot was received, which changes the result of surroundings();
    /// empty: never.
    [[nodiscard]] std::optional<SteadyTime> scanned(const std::string& robot) const;
    [[nodiscard]] MissionStatePtr mission() const;
    [[nodiscard]] LiveMissionStatus log() const;
    [[nodiscard]] const std::filesystem::path& folder() const;  ///< folder of the mission
    [[nodiscard]] StationMapping& mapping();  ///< the map, and the operator's decisions about its scans
    [[nodiscard]] StationClock& clock();      ///< clock of the mission
    /// Sets what reports say about the mission. Time and sender are filled in.
    Result<void> describe(MissionInfoSample info);
    [[nodiscard]] FindDesk& finds();  ///< files victims and other finds
    /// What was searched with each kind of sensor; null: there is no map yet.
    [[nodiscard]] std::shared_ptr<const SearchedFloor> searched() const;
    [[nodiscard]] StationAlarms& alarms();  ///< what the operator must know
    /// Mismatches between robots and this station.
    [[nodiscard]] std::vector<WireComplaint> mismatches() const;
    /// Returns warnings in words about limits of this computer, such as those that cause losses. Empty: there
    /// are none.
    [[nodiscard]] std::vector<std::string> limits() const;
    /// Topics that others publish or subscribe to.
    [[nodiscard]] std::vector<SeenTopic> visibleTopics() const;
    [[nodiscard]] const FrameWatch& frames() const;  ///< the robots' tf trees
    [[nodiscard]] TopicWatch& topicWatch();          ///< looks at one topic, whether it is recorded or not
    [[nodiscard]] const StationSettings& settings() const;  ///< settings with which it was opened

    /// Gives the sticks to one robot; all other robots stand, with their joints. Empty: to no robot.
    void setDriveFocus(const std::string& robot);
    /// Sets the present position of the sticks, also when they are neutral. Call at least ten times a second.
    /// The speed is limited by the age of what the driver sees (SightCap), for any input device, unless
    /// @p withoutEyes is set.
    void setStick(const DriveVelocity& sticks, bool withoutEyes = false);
    /// Ends motions of joints of all robots. Stops the robot that has the sticks until these were neutral. If
    /// it drives itself, requests that it obeys the sticks again.
    void halt();
    /// Sets that the driver of @p robot looks through the camera @p sensor. At first it is the robot's first
    /// camera.
    void selectCamera(const std::string& robot, const std::string& sensor);

    void requestGrant(const std::string& robot);  ///< requests the grant to drive
    void releaseGrant(const std::string& robot);  ///< releases the grant
    /// Answers a request for a grant that this station holds.
    void answerRequest(const std::string& robot, bool consent);

    /// Returns which station makes the map, and which one requests it.
    [[nodiscard]] GrantView mapGrant() const;
    void giveMap();  ///< to the station that requested it first; does nothing if none did
    void stopAll();
    void stop(const std::string& robot);
    Result<void> release(const std::string& robot);  ///< as StopSender::release()

    /// Requests @p mode of a robot. Time and sender are filled in. Errors: the robot takes no modes, or those
    /// of maySend(), except for modes of teleoperation.
    Result<void> setMode(const std::string& robot, const std::string& mode);
    /// Error when @p robot may not be sent anywhere: during its brake test, or while it may not be driven
    /// after one.
    [[nodiscard]] Result<void> maySend(const std::string& robot) const;
    /// Sends @p robot to @p goal. Errors include those of maySend(), and that a stop of it is in force.
    Result<void> goTo(const std::string& robot, const PoseSample& goal);
    /// Asks the navigation of @p robot to give up its goal; does nothing if it has none, or none is known.
    void cancelGoal(const std::string& robot);
    /// Calls the service @p service of @p robot, one of isOperators(); what comes of it is a message. Errors:
    /// another station has its drive control, no such service, or nobody offers it.
    Result<void> call(const std::string& robot, const std::string& service, bool value);
    /// Whether anybody offers that service.
    [[nodiscard]] bool isOffered(const std::string& robot, const std::string& service) const;
    [[nodiscard]] StationBrakes& brakes();    ///< tests of what robots do when commands end
    [[nodiscard]] StationGuards& guards();    ///< guards of robots that continue to drive when commands end
    [[nodiscard]] StationStreams& streams();  ///< rates and qualities of what robots send, and the thin link
    [[nodiscard]] StationCameras& cameras();
    [[nodiscard]] JointMoving& joints();  ///< moves flippers and arms

private:
    struct State;
    explicit Station(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
