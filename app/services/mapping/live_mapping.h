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
    std::vector<ScanPose> poses;                          ///< where they are now
    std::map<std::string, RobotPlaceSample> places = {};  ///< of robots without scans in the map, by name
    bool shared = false;                                  ///< another station contributed to it
    std::vector<ScanLinksSample> links = {};              ///< between the scans, as they were published
    std::vector<Link> loops = {};                         ///< the links that close loops, as they are now
    std::map<std::uint64_t, std::vector<BodyInScan>> bodies = {};  ///< other robots in scans, by scan id
    bool asRecorded = false;  ///< scans keep their poses, whatever links require, until something is decided
};

/// Restores the map of @p earlier in @p mapper, which must be empty. Does not restore the robots' places.
void restore(LiveMapper& mapper, const EarlierMap& earlier);

/// Returns @p settings, adapted to the files of @p robots.
[[nodiscard]] LiveSettings settingsOf(const std::vector<RobotDescription>& robots, LiveSettings settings);

/// Registers the scans of robots while they drive, on its own thread. Any thread.
class LiveMapping : public EventSink {
public:
    LiveMapping(const std::vector<RobotDescription>& robots, const std::string& station,
                const LiveSettings& settings, LiveMappingListener listener, const EarlierMap& earlier = {});
    ~LiveMapping() override;

    void close() override;  ///< drops waiting work; no listener is called any more
    /// Takes odometry, inertial unit, fixed frames, 3D scans, turns of a plane laser, and clock offsets of
    /// robots; ignores others.
    void onEvent(const Event& event) override;
    /// Runs @p task with the mapper on the mapping's thread, after waiting work. The map is then published as
    /// changed.
    void post(std::function<void(LiveMapper&)> task);
    /// Calls @p done on the mapping's thread, once waiting work is done and the poses of scans are solved.
    /// Does not call it if the mapping ends before.
    void whenCalm(std::function<void()> done);
    /// Sets which part of the world belongs into the map from now on, also for what lasers see.
    void setCrop(const MapCrop& crop);
    /// Takes additions to the map from the station that makes it. follow() takes where its scans and robots
    /// are now.
    void adopt(const KeyScanSample& keyScan);
    void adopt(const ScanLinksSample& links);
    void adopt(const ScanBodiesSample& bodies);
    void follow(std::vector<ScanPose> poses);
    void follow(const RobotPlaceSample& place);
    /// Records that a 3D scan of @p robot was received at @p received, station's clock. Another station
    /// registers it.
    void scanReceived(const std::string& robot, Time received);
    /// Places @p robot, the name of one of ours, at @p baseInMap, where the operator puts it.
    void place(const std::string& robot, const Pose& baseInMap);
    /// Computes what the map would become if its links were as in @p links. Calls @p done on another thread,
    /// unless the mapping ends before.
    void preview(std::vector<Link> links, std::function<void(LoopPreview)> done);
    /// Looks for @p robot, the name of one of ours, by its newest 3D scan, as LostRobots::lookFor(); on a
    /// separate thread.
    void lookFor(const std::string& robot);
    /// Corrects the scans of @p robot, the name of one of ours, by @p correction from the next scan on.
    void correct(const std::string& robot, const ScannerCorrection& correction);
    /// Makes the map with the scanner of @p robot, the name of one of ours, whose clouds are on @p topic,
    /// from the next cloud on.
    void mapWith(const std::string& robot, const std::string& topic);
    /// Stops reports of @p fault in the scanner of @p robot; its other faults are still reported.
    void leaveAsIs(const std::string& robot, ScannerFault fault);
    /// Where the robots are; never null.
    [[nodiscard]] RobotsInMapPtr robots() const;

private:
    using Task = std::function<void(LiveMapper&)>;
    /// Reads the mapper, and changes nothing.
    struct Look {
        std::function<void(const LiveMapper&)> look;
    };
    using Work = std::variant<Event, Task, Look>;
    /// What was reported of a robot's scanner.
    struct ScannerReport {
        std::optional<ScannerCorrection> advised;  ///< the correction that was reported last
        std::set<ScannerFault> leftAsIs;           ///< faults that the operator leaves as they are
    };
    void wait(Work work);
    void look(std::function<void(const LiveMapper&)> look);  ///< after waiting work
    void run(const std::stop_token& stop);
    void work(const Event& event);
    void work(const Task& task);
    void work(const Look& look);
    void registerDone(Time now);
    /// Makes the matched clouds of an earlier map's scans on the solver's thread: those in @p left, the last
    /// one first.
    void makeMatched(std::vector<MatchedCloudPtr> left);
    void solveLoops();  ///< solves loop closures, on the solver's thread
    void settle(const MapSolution& solution);
    void meetMore();   ///< checks one more scan of two parts that have met, and links them
    void seekPlace();  ///< searches for loop closures far off, on the solver's thread
    void publishScanner(const std::string& name);
    void publishMap();

    MappingContext m_context;  ///< of the thread, as is all down to m_calmed
    MappedRobots m_robots;
    RobotPlacing m_placing;
    LostRobots m_lost;
    LeftOutBodies m_bodies;
    std::map<std::string, ScannerReport> m_scanners;  ///< by robot
    bool m_solves = false;                            ///< something is being solved
    bool m_seeks = false;                             ///< a place is being looked for
    std::vector<std::function<void()>> m_calmed;      ///< of whenCalm()
    std::mutex m_mutex;
    std::condition_variable_any m_came;
    std::deque<Work> m_waiting;  ///< under the mutex
    std::jthread m_solver;
    std::jthread m_thread;  ///< last: joined first
};

/// Returns @p map for the map view: the scans that are not set aside. Reuses the label counts that @p before
/// has for the same scans, so that only new scans cost time.
[[nodiscard]] MapPtr shownMap(const LiveMap& map, const MapPtr& before = nullptr);

}  // namespace leitstand
