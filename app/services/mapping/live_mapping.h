#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "app/services/job_queue.h"
#include "app/services/log/event_sink.h"
#include "app/services/places/sensor_poses.h"
#include "core/event/event.h"
#include "core/mapping/live/live_mapper.h"
#include "core/mapping/live/loops/loop_preview.h"
#include "core/mapping/live/robot_in_map.h"
#include "core/mapping/live/robot_tracker.h"
#include "core/mapping/map.h"
#include "core/mapping/motion/scan_cutter.h"
#include "core/mapping/placement/laser_robot.h"
#include "core/mapping/relocalisation/place_recognition.h"
#include "core/mapping/relocalisation/relocaliser.h"
#include "core/mapping/sighting/passing_bodies.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Called on the mapping's thread, which they must not block.
struct LiveMappingListener {
    std::function<void(const RobotPlaceSample&)> onPlace =
        {};  ///< places for the log, of robots that do not make the map
    std::function<void(const MapUpdate&)> onUpdate = {};  ///< for the log, in order
    /// For the log: a place was recognised far off, or in another part of the map.
    std::function<void(const ScanLinksSample&)> onLoop = {};
    std::function<void(const Settled&)> onSettled = {};  ///< for the log, after a loop closed or an undo
    /// For the log, without a station: other robots in a scan that entered before they were placed, and
    /// passers-by.
    std::function<void(ScanBodiesSample)> onBodies = {};
    /// A search for a robot in the whole map failed: @p alike places look like what it sees, or none.
    std::function<void(const std::string& robot, std::size_t alike)> onLookedFor = {};
    /// What the map advises about a robot's scanner. Called when it changes noticeably.
    std::function<void(const std::string& robot, const ScannerFinding&)> onScanner = {};
    std::function<bool()> makesMap = {};  ///< whether our poses of scans are valid; empty: they are
    std::function<void(const LiveMapPtr&)> onMap = {};  ///< after a scan entered or moved, or was decided on
};

/// The map of the mission's earlier sessions.
struct EarlierMap {
    std::vector<KeyScanSample> scans;
    std::vector<ScanPose> poses;                          ///< where they are now
    std::map<std::string, RobotPlaceSample> places = {};  ///< of robots that do not make it, by name
    bool shared = false;                                  ///< another station contributed to it
    std::vector<ScanLinksSample> links = {};              ///< between the scans, as they were published
    std::vector<Link> loops = {};                         ///< those links that close loops, as they are now
    std::map<std::uint64_t, std::vector<BodyInScan>> bodies = {};  ///< of other robots, by scan
    bool asRecorded = false;  ///< scans keep their poses, whatever links require, until something is decided
};

/// Restores the map of @p earlier in @p mapper, which is empty. Does not restore where robots are in it.
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
    /// Runs @p task with the mapper, on the mapping's thread, after waiting work. The map then counts as
    /// moved.
    void post(std::function<void(LiveMapper&)> task);
    /// Calls @p done on the mapping's thread, once waiting work is done and the poses of scans are solved.
    /// Does not call it if the mapping ends before.
    void whenCalm(std::function<void()> done);
    /// Sets what of the world, and of what lasers see, belongs into the map from now on.
    void setCrop(const MapCrop& crop);
    /// Takes what another station, which makes the map, added to it. follow() takes where its scans and
    /// robots are now.
    void adopt(const KeyScanSample& keyScan);
    void adopt(const ScanLinksSample& links);
    void adopt(const ScanBodiesSample& bodies);
    void follow(std::vector<ScanPose> poses);
    void follow(const RobotPlaceSample& place);
    /// Records that a 3D scan of @p robot came in, which another station registers.
    void scanReceived(const std::string& robot, Time received);
    /// Sets @p robot, by name one of ours, to @p baseInMap, for the operator.
    void place(const std::string& robot, const Pose& baseInMap);
    /// Computes what the map would become if its links were as in @p links. Calls @p done on another thread,
    /// unless the mapping ends before.
    void preview(std::vector<Link> links, std::function<void(LoopPreview)> done);
    /// Looks for @p robot, by name one of ours, in the whole map, by its newest 3D scan; on a separate
    /// thread.
    void lookFor(const std::string& robot);
    /// Corrects the scans of @p robot, by name one of ours, by @p correction from the next one on.
    void correct(const std::string& robot, const ScannerCorrection& correction);
    /// Stops reports of the present @p fault of @p robot's scanner; later changes are reported.
    void leaveAsIs(const std::string& robot, ScannerFault fault);
    /// Where the robots are; never null.
    [[nodiscard]] RobotsInMapPtr robots() const;

private:
    /// A scan as received, and as it would enter the map.
    struct SeenScan {
        LiveScan live;
        ScanPtr ready;
    };
    struct Robot {
        Robot(const RobotDescription& description, const std::string& station);
        SensorPoses poses;
        std::map<std::string, ScanCutter> cutters;  ///< by topic of its scanner
        RobotTracker tracker;
        LaserRobot laser;                        ///< corrects the tracker while none of its own 3D scans does
        std::chrono::nanoseconds ahead{};        ///< how far its clock is ahead of the station's
        std::optional<Time> matched;             ///< RobotInMap::matched
        std::optional<RobotFix> followed;        ///< the fix that corrected the tracker last
        std::shared_ptr<const SeenScan> newest;  ///< its newest scan that has enough points
        std::uint64_t put = 0;  ///< how often somebody set where it stands, or asked to look for it
        int unplaced = 0;       ///< its 3D scans while its place was unknown
        int lost = 0;           ///< its consecutive 3D scans that did not fit
        bool sought = false;    ///< it is being looked for unasked ...
        int soughtAt = 0;       ///< ... since so many of them
        int vain = 0;           ///< consecutive unasked searches that found nothing
        /// Where an unasked search found it once: another find has to agree.
        struct Find {
            Pose baseInMap, baseInOdom;
            int frame = 0;
        };
        std::optional<Find> find;
        std::string scanner;                       ///< its only scanner; empty: it has several, or none
        std::optional<ScannerCorrection> advised;  ///< the correction that was reported last
        std::set<ScannerFault> leftAsIs;           ///< faults that the operator leaves as they are
        bool certain = false;                      ///< whether its place is certain
        std::optional<Time> wasSure;    ///< when its place was certain last, station's clock; empty: never
        std::optional<Pose> wasSureBy;  ///< where its odometry frame lay in the map then
    };
    using Task = std::function<void(LiveMapper&)>;
    /// Reads the mapper, and changes nothing.
    struct Look {
        std::function<void(const LiveMapper&)> look;
    };
    using Work = std::variant<Event, Task, Look>;
    void look(std::function<void(const LiveMapper&)> look);  ///< after waiting work
    void run(const std::stop_token& stop);
    void work(const Event& event);
    void work(const Task& task);
    void work(const Look& look) { look.look(m_mapper); }
    void registerDone(Time now);
    void matched(const std::string& name, Time now);  ///< a scan of it was registered here
    /// Makes the matched clouds of an earlier map's scans, on the solver's thread; of @p left, the last one
    /// first.
    void makeMatched(std::vector<MatchedCloudPtr> left);
    void solveLoops();  ///< solves where the map meets itself, on the solver's thread
    void settle(const MapSolution& solution);
    void publishScanner(const std::string& name, Robot& robot);
    void meetMore();        ///< links two parts that have met at one more of their scans
    void seekPlace();       ///< searches where the map may meet itself far off, on the solver's thread
    void lookForPassing();  ///< searches scans for passers-by, on the solver's thread
    void leaveOutPassing(std::map<std::uint64_t, std::vector<BodyInScan>> found);
    void carryAlong();           ///< moves robots without scans in the map with the scans about them
    void followFixes();          ///< sets robots to where the mapper has them
    void layTrails();            ///< moves trails to where decisions moved the scans
    void placeOthers(Time now);  ///< places robots that do not make the map, beside the one that does ...
    void placeBeside(const std::string& name, Robot& robot, Time now);
    /// Returns the first key scan of a robot of ours. Without one, returns the first of the map, which was
    /// carried here. Null: no map.
    [[nodiscard]] const LiveKeyScan* firstOfOurs() const;
    /// ... or where the scan of @p update shows them; @p before: the map without it.
    void placeSeen(const MapUpdate& update, const LiveMapPtr& before, Time now);
    void place(Robot& robot, const LiveScan& scan, Time now);
    /// Looks unasked for a robot whose scans no longer fit, by @p update. When that fails for long, the robot
    /// goes on in its own part of the map.
    void seekLost(const std::string& name, Robot& robot, const MapUpdate& update);
    /// Whether somebody waits for the result of a search for a robot.
    enum class Search : std::uint8_t { Asked, Unasked };
    /// Looks for @p name in @p part of the map: the part with its scans, whose place relative to others may
    /// be unknown.
    void lookInOwnPart(const std::string& name, std::uint64_t part, Search search);
    /// Looks for @p name, whose scans form their own part of the map, in the other parts.
    void lookElsewhere(const std::string& name);
    /// Takes the result of a search for @p name with @p scan in @p map: goes on from where it was found.
    void lookedFor(const std::string& name, const SeenScan& scan, const LiveMapPtr& map,
                   const Relocalisation& found, Search search);
    void lookedInVain(const std::string& name, std::size_t alike, Search search);
    /// Whether an unasked find at @p baseInMap, by a scan that ended at @p end, agrees with an earlier find
    /// and the odometry since. Rooms look alike, paths through them less so.
    [[nodiscard]] static bool findsAgree(Robot& robot, const Pose& baseInMap, Time end);
    void seeing(const std::string& name, Robot& robot, LaserView view, Time now);
    /// Returns robots that @p scan, of another one, may have points of; of robot @p only if it is named.
    [[nodiscard]] std::vector<PlacedBody> bodiesIn(const Scan& scan, const std::string& only = {}) const;
    /// Leaves a robot whose place became certain out of scans from before, as far back as odometry shows
    /// where it was. Returns whether the map has changed.
    bool leaveOutPlaced(Time now);
    /// ... robot @p name, out of scans that entered @p since (station's clock; empty: ever). Adds to @p found
    /// what is left out of those scans now.
    void leaveOut(const std::string& name, const std::optional<Time>& since,
                  std::map<std::uint64_t, std::vector<BodyInScan>>& found);
    /// Reports what is left out of scans now.
    void publishBodies(std::map<std::uint64_t, std::vector<BodyInScan>> found, Time now);
    [[nodiscard]] std::vector<Disc> othersThan(const Robot& robot, bool certain) const;
    void publishPlace(const std::optional<RobotPlaceSample>& place);
    void publishMap();
    void publishRobots();
    [[nodiscard]] std::optional<Time> due() const;
    ScanCutter& cutterOf(Robot& robot, const Event& event);

    const std::vector<RobotDescription> m_descriptions;
    const LiveMappingListener m_listener;
    const LiveSettings m_settings;
    LiveMapper m_mapper;                    ///< of the thread, as are the robots
    LiveMapPtr m_map;                       ///< newest; of the thread; null before there is one
    std::map<std::string, Robot> m_robots;  ///< the set is fixed
    mutable std::mutex m_mutex;
    std::condition_variable_any m_came;
    std::deque<Work> m_waiting;              ///< under the mutex
    RobotsInMapPtr m_places;                 ///< under the mutex
    std::map<std::string, Time> m_received;  ///< under the mutex: newest scans that other stations register
    bool m_solves = false;                   ///< something is being solved; of the thread
    std::vector<std::function<void()>> m_calmed;  ///< of whenCalm(); of the thread
    bool m_seeks = false;                         ///< a place is being looked for; of the thread
    MapCrop m_crop;                               ///< what of the world belongs into the map; of the thread
    std::vector<std::uint64_t> m_entered;  ///< key scans not searched for passers-by yet; of the thread
    std::atomic<bool> m_looksForPassing = false;
    PassingBodies m_passing;  ///< of the solver's thread
    JobQueue m_solving;       ///< jobs of the solver
    std::jthread m_solver;
    std::jthread m_thread;  ///< last: joined first
};

/// Whether scans of @p before, which may be null, have other poses in @p after, or were set aside or taken
/// back since.
[[nodiscard]] bool scansMoved(const LiveMapPtr& before, const LiveMap& after);

/// Returns @p map for the map view: the scans that are not set aside. Reuses the label counts that @p before
/// has for the same scans, so that only new scans cost time.
[[nodiscard]] MapPtr shownMap(const LiveMap& map, const MapPtr& before = nullptr);

}  // namespace leitstand
