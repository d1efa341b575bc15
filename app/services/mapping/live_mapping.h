#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "app/services/log/event_sink.h"
#include "app/services/mapping/live_mapping_listener.h"
#include "app/services/mapping/robots/left_out_bodies.h"
#include "app/services/mapping/robots/lost_robots.h"
#include "app/services/mapping/robots/mapped_robots.h"
#include "app/services/mapping/robots/mapping_context.h"
#include "app/services/mapping/robots/robot_placing.h"
#include "core/event/event.h"
#include "core/event/scan_bodies.h"
#include "core/mapping/live/live_mapper.h"
#include "core/mapping/live/loops/loop_preview.h"
#include "core/mapping/map.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// The map of the mission's earlier sessions.
struct EarlierMap {
    std::vector<KeyScanSample> scans;
    std::vector<ScanPose> poses;  ///< present poses of its scans
    /// Places of robots without scans in the map, by name.
    std::map<std::string, RobotPlaceSample> places = {};
    bool shared = false;                      ///< whether another station contributed to it
    std::vector<ScanLinksSample> links = {};  ///< links between the scans, as they were published
    std::vector<Link> loops = {};             ///< links that close loops, in their present state
    /// Other robots in scans, by id of the scan.
    std::map<std::uint64_t, std::vector<BodyInScan>> bodies = {};
    /// Scans keep their poses, whatever links require, until there is a new decision.
    bool asRecorded = false;
};

/// Restores the map of @p earlier in @p mapper, which must be empty. The robots' places are not restored.
void restore(LiveMapper& mapper, const EarlierMap& earlier);

/// Returns @p settings, adapted to the files of @p robots.
[[nodiscard]] LiveSettings settingsOf(const std::vector<RobotDescription>& robots, LiveSettings settings);

/// Registers the scans of robots while they drive, on its own thread. Any thread.
class LiveMapping : public EventSink {
public:
    LiveMapping(const std::vector<RobotDescription>& robots, const std::string& station,
                const LiveSettings& settings, LiveMappingListener listener, const EarlierMap& earlier = {});
    ~LiveMapping() override;

    void close() override;  ///< discards waiting work; afterwards no listener is called
    /// Takes odometry, inertial unit, fixed frames, 3D scans, turns of a plane laser, and clock offsets of
    /// robots; ignores other events.
    void onEvent(const Event& event) override;
    /// Runs @p task with the mapper on the mapping's thread, after waiting work. Then the map is published as
    /// changed.
    void post(std::function<void(LiveMapper&)> task);
    /// Calls @p done on the mapping's thread when waiting work is done and the poses of scans are solved. If
    /// the mapping ends before that, it is not called.
    void whenCalm(std::function<void()> done);
    /// Sets the area that belongs to the map from now on, also for what lasers see.
    void setCrop(const MapCrop& crop);
    /// Takes additions to the map from the station that makes it. The present poses of its scans and robots
    /// are taken by follow().
    void adopt(const KeyScanSample& keyScan);
    void adopt(const ScanLinksSample& links);
    void adopt(const ScanBodiesSample& bodies);
    void follow(std::vector<ScanPose> poses);
    void follow(const RobotPlaceSample& place);
    /// Notes that a 3D scan of @p robot was received at @p received (station's clock), which another station
    /// registers.
    void scanReceived(const std::string& robot, Time received);
    /// Places @p robot, which must be one of this station's robots, at @p baseInMap, as the operator says.
    void place(const std::string& robot, const Pose& baseInMap);
    /// Computes how the map would become with links as in @p links. Calls @p done on another thread, unless
    /// the mapping ends before.
    void preview(std::vector<Link> links, std::function<void(LoopPreview)> done);
    /// Looks for @p robot, which must be one of this station's robots, by its newest 3D scan, like
    /// LostRobots::lookFor(); on a separate thread.
    void lookFor(const std::string& robot);
    /// Applies @p correction to the scans of @p robot, which must be one of this station's robots, from the
    /// next scan on.
    void correct(const std::string& robot, const ScannerCorrection& correction);
    /// Makes the map with the scanner of @p robot whose clouds are on @p topic, from the next cloud on. The
    /// robot must be one of this station's.
    void mapWith(const std::string& robot, const std::string& topic);
    /// Stops reports of @p fault about the scanner of @p robot. Its other faults are still reported.
    void leaveAsIs(const std::string& robot, ScannerFault fault);
    /// Where the robots are; never null.
    [[nodiscard]] RobotsInMapPtr robots() const;

private:
    using Task = std::function<void(LiveMapper&)>;
    /// Reads the mapper, but does not change it.
    struct Look {
        std::function<void(const LiveMapper&)> look;
    };
    using Work = std::variant<Event, Task, Look>;
    /// What was reported about a robot's scanner.
    struct ScannerReport {
        std::optional<ScannerCorrection> advised;  ///< correction that was suggested last
        std::set<ScannerFault> leftAsIs;           ///< faults that the operator does not want to correct
    };
    void wait(Work work);
    void look(std::function<void(const LiveMapper&)> look);  ///< runs after waiting work
    void run(const std::stop_token& stop);
    void work(const Event& event);
    void work(const Task& task);
    void work(const Look& look);
    void registerDone(Time now);
    /// Makes the matched clouds of an earlier map's scans on the solver's thread: those in @p left, beginning
    /// with the last one.
    void makeMatched(std::vector<MatchedCloudPtr> left);
    void solveLoops();  ///< solves the map after loop closures, on the solver's thread
    void settle(const MapSolution& solution);
    void meetMore();   ///< checks one more scan of two parts that were joined, and links them
    void seekPlace();  ///< searches for distant loop closures, on the solver's thread
    void publishScanner(const std::string& name);
    void publishMap();

    MappingContext m_context;  ///< used by the thread, like all members down to m_calmed
    MappedRobots m_robots;
    RobotPlacing m_placing;
    LostRobots m_lost;
    LeftOutBodies m_bodies;
    std::map<std::string, ScannerReport> m_scanners;  ///< by robot
    bool m_solves = false;                            ///< whether something is being solved
    bool m_seeks = false;                             ///< whether a place is being looked for
    std::vector<std::function<void()>> m_calmed;      ///< functions given to whenCalm()
    std::mutex m_mutex;
    std::condition_variable_any m_came;
    std::deque<Work> m_waiting;  ///< under the mutex
    std::jthread m_solver;
    std::jthread m_thread;  ///< the last member, so that it is joined first
};

/// Returns @p map for the map view: the scans that are not set aside. Label counts of scans that are also in
/// @p before are reused, so that only new scans take time.
[[nodiscard]] MapPtr shownMap(const LiveMap& map, const MapPtr& before = nullptr);

}  // namespace leitstand
