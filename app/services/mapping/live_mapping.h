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

/// Called on the mapping's thread, which they must not hold up.
struct LiveMappingListener {
    std::function<void(const RobotPlaceSample&)> onPlace =
        {};                                               ///< likewise, of robots that do not make the map
    std::function<void(const MapUpdate&)> onUpdate = {};  ///< for the log, in order
    /// Likewise: a place was recognised far off, or in another part of the map.
    std::function<void(const ScanLinksSample&)> onLoop = {};
    std::function<void(const Settled&)> onSettled = {};  ///< likewise, after a loop closed or was taken back
    /// Likewise, without a station: other robots in a scan that entered before they were placed, and who
    /// passed by.
    std::function<void(ScanBodiesSample)> onBodies = {};
    /// A robot was looked for in the whole map in vain: so many places look as what it sees, or none.
    std::function<void(const std::string& robot, std::size_t alike)> onLookedFor = {};
    /// The map advises to correct the scanner of a robot so, beyond what is corrected already; empty: not any
    /// more. Told when that changes noticeably.
    std::function<void(const std::string& robot, const std::optional<ScannerCorrection>& more)> onScanner =
        {};
    std::function<bool()> makesMap = {};                ///< whether scans stand where we say; empty: they do
    std::function<void(const LiveMapPtr&)> onMap = {};  ///< after a scan entered or moved, or was decided on
};

/// What the mission's earlier sessions have of the map.
struct EarlierMap {
    std::vector<KeyScanSample> scans;
    std::vector<ScanPose> poses;                          ///< where they are now
    std::map<std::string, RobotPlaceSample> places = {};  ///< of robots that do not make it, by name
    bool shared = false;                                  ///< another station had a part in it
    std::vector<ScanLinksSample> links = {};              ///< between the scans, as they were said
    std::vector<Link> loops = {};                         ///< of those, what closes loops, as it is now
    std::map<std::uint64_t, std::vector<BodyInScan>> bodies = {};  ///< of other robots, by scan
    bool asRecorded = false;  ///< scans stay where they are, whatever links say, until something is decided
};

/// Gives @p mapper, which is empty, the map that @p earlier has; not where robots are in it.
void restore(LiveMapper& mapper, const EarlierMap& earlier);

/// @p settings as the files of @p robots want them.
[[nodiscard]] LiveSettings settingsOf(const std::vector<RobotDescription>& robots, LiveSettings settings);

/// Registers what robots scan while they drive, on a thread of its own. Any thread.
class LiveMapping : public EventSink {
public:
    LiveMapping(const std::vector<RobotDescription>& robots, const std::string& station,
                const LiveSettings& settings, LiveMappingListener listener, const EarlierMap& earlier = {});
    ~LiveMapping() override;

    void close() override;  ///< what waits is left; nobody is told anything any more
    /// Odometry, inertial unit, fixed frames, 3D scans, turns of a plane laser, how far robots' clocks are
    /// ahead; others are passed by.
    void onEvent(const Event& event) override;
    /// Lets @p task have the mapper, on the mapping's thread, after what waits; the map counts as moved then.
    void post(std::function<void(LiveMapper&)> task);
    /// @p done is called, on the mapping's thread, once all that waits is done and where scans stand is
    /// worked out; not where the mapping ends before.
    void whenCalm(std::function<void()> done);
    /// What of the world belongs into the map from now on, and of what lasers see.
    void setCrop(const MapCrop& crop);
    /// What another station, which makes the map, added to it, and where its scans and robots are now.
    void adopt(const KeyScanSample& keyScan);
    void adopt(const ScanLinksSample& links);
    void adopt(const ScanBodiesSample& bodies);
    void follow(std::vector<ScanPose> poses);
    void follow(const RobotPlaceSample& place);
    /// A 3D scan of @p robot came in, which another station lays onto the map.
    void heard(const std::string& robot, Time received);
    /// The operator puts @p robot, by name one of ours, to @p baseInMap.
    void place(const std::string& robot, const Pose& baseInMap);
    /// Works out what the map would become if @p links were as they are there; @p done is called on another
    /// thread, unless the mapping ends before.
    void preview(std::vector<Link> links, std::function<void(LoopPreview)> done);
    /// Looks for @p robot, by name one of ours, in the whole map, by its newest 3D scan; on a thread beside.
    void lookFor(const std::string& robot);
    /// Scans of @p robot, by name one of ours, are corrected so from the next one on.
    void correct(const std::string& robot, const ScannerCorrection& correction);
    /// What the map finds to be off of @p robot's scanner is not told any more, and what comes after it is.
    void leaveAsIs(const std::string& robot, ScannerFault fault);
    /// Where the robots are; never null.
    [[nodiscard]] RobotsInMapPtr robots() const;

private:
    /// A scan as it came, and as it would enter the map.
    struct SeenScan {
        LiveScan live;
        ScanPtr ready;
    };
    struct Robot {
        Robot(const RobotDescription& description, const std::string& station);
        SensorPoses poses;
        std::map<std::string, ScanCutter> cutters;  ///< by topic of its scanner
        RobotTracker tracker;
        LaserRobot laser;                        ///< corrects the tracker while no 3D scan of its own does
        std::chrono::nanoseconds ahead{};        ///< its clock, of the station's
        std::optional<Time> matched;             ///< RobotInMap::matched
        std::optional<RobotFix> followed;        ///< that the tracker was corrected by last
        std::shared_ptr<const SeenScan> newest;  ///< its newest scan that has enough points
        std::uint64_t put = 0;                   ///< how often somebody said where it stands
        int unplaced = 0;                        ///< its 3D scans while nobody knew where it is
        int lost = 0;                            ///< its 3D scans, one after another, that did not fit
        bool sought = false;                     ///< it is being looked for unasked ...
        int soughtAt = 0;                        ///< ... as of so many of them
        int vain = 0;                            ///< times that this found nothing, one after another
        /// Where it was found unasked, once: another find has to agree.
        struct Find {
            Pose baseInMap, baseInOdom;
            int frame = 0;
        };
        std::optional<Find> find;
        std::string scanner;                       ///< its only one; empty: it has several, or none
        std::optional<ScannerCorrection> advised;  ///< that was told about it
        std::set<ScannerFault> leftAsIs;           ///< of it, by the operator
        bool certain = false;                      ///< its place is
        std::optional<Time> wasSure;               ///< when it was last, station's clock; empty: never
        std::optional<Pose> wasSureBy;             ///< where its odometry lay in the map then
    };
    using Task = std::function<void(LiveMapper&)>;
    /// Looks at the mapper, and changes nothing.
    struct Look {
        std::function<void(const LiveMapper&)> look;
    };
    using Work = std::variant<Event, Task, Look>;
    void look(std::function<void(const LiveMapper&)> look);  ///< after what waits
    void run(const std::stop_token& stop);
    void work(const Event& event);
    void work(const Task& task);
    void work(const Look& look) { look.look(m_mapper); }
    void registerDone(Time now);
    void matched(const std::string& name, Time now);  ///< a scan of it was laid onto the map here
    /// Makes what is matched of scans of an earlier map, on the solver's thread: of @p left, the last one
    /// first.
    void makeMatched(std::vector<MatchedCloudPtr> left);
    void solveLoops();  ///< where the map meets itself, on a thread beside
    void settle(const MapSolution& solution);
    void tellScanner(const std::string& name, Robot& robot);
    void meetMore();        ///< where two parts have met, at one more of their scans
    void seekPlace();       ///< where the map may meet itself far off, likewise
    void lookForPassing();  ///< who passed by in scans, likewise
    void leaveOutPassing(std::map<std::uint64_t, std::vector<BodyInScan>> found);
    void carryAlong();           ///< robots without scans in the map, with the scans about them
    void followFixes();          ///< robots stand where the mapper says
    void layTrails();            ///< where decisions moved the scans
    void placeOthers(Time now);  ///< robots that do not make the map, beside the one that does ...
    void placeBeside(const std::string& name, Robot& robot, Time now);
    /// Where a robot of ours began; before one did, where one of a map did that was carried here. Null: no
    /// map.
    [[nodiscard]] const LiveKeyScan* firstOfOurs() const;
    /// ... or where its scan, which came to @p update, shows them; @p before: the map without it.
    void placeSeen(const MapUpdate& update, const LiveMapPtr& before, Time now);
    void place(Robot& robot, const LiveScan& scan, Time now);
    /// Of one whose scans fit no more, as @p update says: it is looked for unasked, and where that is in vain
    /// for long goes on in a part of the map of its own.
    void seekLost(const std::string& name, Robot& robot, const MapUpdate& update);
    /// Whether somebody waits for what comes of looking for a robot.
    enum class Search : std::uint8_t { Asked, Unasked };
    /// Looks for @p name where its scans already are, or where nobody knows how that lies: in its own part.
    void lookInOwnPart(const std::string& name, std::uint64_t part, Search search);
    /// Looks for @p name, whose scans make a part of the map of their own, in the others.
    void lookElsewhere(const std::string& name);
    /// It was looked for, with @p scan, in @p map: goes on from where it was found.
    void lookedFor(const std::string& name, const SeenScan& scan, const LiveMapPtr& map,
                   const Relocalisation& found, Search search);
    void lookedInVain(const std::string& name, std::size_t alike, Search search);
    /// Whether what was found unasked at @p baseInMap, by a scan that ended then, is where an earlier find
    /// and odometry since have it: rooms look alike, ways through them less so.
    [[nodiscard]] static bool findsAgree(Robot& robot, const Pose& baseInMap, Time end);
    void seeing(const std::string& name, Robot& robot, LaserView view, Time now);
    /// Robots that @p scan, of another one, may have points of; of robot @p only where it is named.
    [[nodiscard]] std::vector<PlacedBody> bodiesIn(const Scan& scan, const std::string& only = {}) const;
    /// A robot whose place became certain is left out of what was scanned while it was not, as far back as
    /// its odometry tells where it was. Whether the map has changed.
    bool leaveOutPlaced(Time now);
    /// ... robot @p name, out of what entered @p since (station's clock; empty: ever); adds to @p found what
    /// is left out of those scans now.
    void leaveOut(const std::string& name, const std::optional<Time>& since,
                  std::map<std::uint64_t, std::vector<BodyInScan>>& found);
    /// Says what is left out of scans now.
    void tellBodies(std::map<std::uint64_t, std::vector<BodyInScan>> found, Time now);
    [[nodiscard]] std::vector<Disc> othersThan(const Robot& robot, bool certain) const;
    void tellPlace(const std::optional<RobotPlaceSample>& place);
    void tellMap();
    void tellRobots();
    [[nodiscard]] std::optional<Time> due() const;
    ScanCutter& cutterOf(Robot& robot, const Event& event);

    const std::vector<RobotDescription> m_descriptions;
    const LiveMappingListener m_listener;
    const LiveSettings m_settings;
    LiveMapper m_mapper;                    ///< of the thread, as the robots
    LiveMapPtr m_map;                       ///< newest; likewise, null before there is one
    std::map<std::string, Robot> m_robots;  ///< fixed
    mutable std::mutex m_mutex;
    std::condition_variable_any m_came;
    std::deque<Work> m_waiting;           ///< under the mutex
    RobotsInMapPtr m_places;              ///< likewise
    std::map<std::string, Time> m_heard;  ///< likewise: robots' newest scans that others lay onto the map
    bool m_solves = false;                ///< something is being solved; of the thread
    std::vector<std::function<void()>> m_calmed;  ///< of whenCalm(); likewise
    bool m_seeks = false;                         ///< a place is being looked for; likewise
    MapCrop m_crop;                               ///< what of the world belongs into the map; of the thread
    std::vector<std::uint64_t> m_entered;  ///< key scans that nobody who passed was looked for in; likewise
    std::atomic<bool> m_looksForPassing = false;
    PassingBodies m_passing;  ///< of the solver's thread
    JobQueue m_solving;       ///< by the solver
    std::jthread m_solver;
    std::jthread m_thread;  ///< last: joined first
};

/// Whether scans of @p before, which may be null, stand elsewhere in @p after, or are set aside there or no
/// more.
[[nodiscard]] bool scansMoved(const LiveMapPtr& before, const LiveMap& after);

/// @p map as the map view takes it: scans that were not set aside. What @p before counted in the points of
/// the same scans is not counted again: it costs as much as came in between.
[[nodiscard]] MapPtr shownMap(const LiveMap& map, const MapPtr& before = nullptr);

}  // namespace leitstand
