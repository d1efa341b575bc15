#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/services/coverage/coverage_watch.h"
#include "app/services/domain/model_watch.h"
#include "app/services/domain/reception_watch.h"
#include "app/services/finds/find_desk.h"
#include "app/services/heap_keeper.h"
#include "app/services/log/mission_feed.h"
#include "app/services/station/cameras/station_cameras.h"
#include "app/services/station/frame_watch.h"
#include "app/services/station/joints/joint_moving.h"
#include "app/services/station/lines/robot_lines.h"
#include "app/services/station/safety/station_alarms.h"
#include "app/services/station/safety/station_brakes.h"
#include "app/services/station/safety/station_guards.h"
#include "app/services/station/station.h"
#include "app/services/station/station_clock.h"
#include "app/services/station/station_mapping.h"
#include "app/services/station/station_services.h"
#include "app/services/station/station_streams.h"
#include "app/services/team/mission_sharing.h"
#include "app/services/team/shared_intake.h"
#include "app/services/topics/topic_watch.h"
#include "app/services/victims/victim_watch.h"
#include "core/io/settings/station_file.h"
#include "core/robot/link/screen_report.h"
#include "transport/dds/node.h"
#include "transport/dds/ros_nodes.h"
#include "transport/dds/ros_presence.h"

namespace leitstand {

/// Grant of the map. Its holder registers scans; otherwise each station would make its own map of the same
/// scans.
inline const GrantId MapGrant{GrantSample::Kind::Map, {}};

/// All parts of a station, in the order in which they can be made and destroyed.
struct Station::State {
    StationSettings settings;
    StationListener listener;
    std::optional<StationFile> memory;
    std::unique_ptr<Node> node;
    FrameWatch frames;
    std::optional<TopicWatch> topicWatch;
    std::optional<ModelWatch> modelWatch;
    std::optional<RosNodeWatch> rosNodes;  ///< knows the nodes of all processes in the domain
    std::optional<RosPresence> presence;   ///< announces this one among them
    std::unique_ptr<GrantKeeper> grants;
    std::unique_ptr<StopSender> stops;
    std::unique_ptr<StationStreams> streams;
    std::unique_ptr<StationBrakes> brakes;
    std::unique_ptr<StationGuards> guards;
    RobotLines lines;  ///< not changed while open
    std::unique_ptr<JointMoving> joints;
    std::unique_ptr<StationCameras> cameras;
    std::unique_ptr<LiveMission> mission;
    std::unique_ptr<StationMapping> mapping;
    std::unique_ptr<VictimWatch> victims;
    std::unique_ptr<CoverageWatch> coverage;
    std::unique_ptr<StationClock> clock;
    std::unique_ptr<FindDesk> finds;
    std::unique_ptr<StationAlarms> alarms;
    std::unique_ptr<SharedIntake> intake;
    std::unique_ptr<MissionSharing> sharing;
    std::unique_ptr<MissionFeed> feed;
    std::unique_ptr<ReceptionWatch> reception;
    StationServices services;        ///< parts from above that follow the mission; not changed while open
    std::mutex mutex;                ///< guards the next three members
    std::atomic<bool> open = false;  ///< everything exists; changed under the mutex
    std::set<std::string> reported;  ///< mismatches that were reported; under the mutex
    ScreenMessages screened;         ///< under the mutex
    std::map<FindSample::Kind, std::uint32_t>
        filedAgain;  ///< numbers that were given last; used by the callers of the intake
    HeapKeeper heap;

    ~State();
    Result<void> start();
    Result<void> control();
    Result<void> lineTo(const RobotDescription& robot);
    void watchStreams();
    void watchBrakes();
    void guardRobots();
    void moveJoints();
    /// Whether the operator may move @p robot now, by driving it or otherwise.
    [[nodiscard]] bool mayMove(const std::string& robot) const;
    void map(std::vector<KeyScanSample> earlier, std::vector<ScanLinksSample> links);
    void search();
    void cover(std::vector<KeyScanSample> earlier);
    void watch();
    void file();
    void share();
    void follow();  ///< adds the parts that follow the mission to `services`
    /// Files it under the next number, because another station's find has its number.
    void fileAgain(FindSample find);
    void listen();
    void watchReception();
    [[nodiscard]] bool isAtRest() const;  ///< whether this station moves nothing, and stops nothing
    [[nodiscard]] RobotView view(const std::string& robot) const;
    void refresh(const std::string& robot);  ///< empty: all robots
    void notify(const std::string& text) const {
        if (listener.onMessage) listener.onMessage(text);
    }
    void notifyMismatches();
    void notifyDrops();
    [[nodiscard]] RobotLine* line(const std::string& robot) const {
        const auto found = lines.find(robot);
        return found == lines.end() ? nullptr : found->second.get();
    }
    [[nodiscard]] Result<void> request(const std::string& robot, StreamRole role, const Sample& sample) const;
};

}  // namespace leitstand
