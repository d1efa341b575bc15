#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/mapping/calibration/range_bias.h"
#include "core/mapping/calibration/scanner_lean.h"
#include "core/mapping/calibration/scanner_mount.h"
#include "core/mapping/live/live_mapper.h"
#include "core/mapping/live/loops/loop_closer.h"
#include "core/mapping/live/map/cropped_scans.h"
#include "core/mapping/live/map/local_map.h"
#include "core/mapping/live/scan_work.h"
#include "core/mapping/motion/odometry_scale.h"
#include "core/mapping/motion/spinning_wheels.h"

namespace leitstand {

/// What is known of a robot's way.
struct RobotTrack {
    RobotBody body;
    bool known = false;  ///< whether the following is
    Time stamp{};        ///< end of the newest scan, robot's clock
    Pose sensorInBase = Pose::Identity();
    Pose sensorInMap = Pose::Identity();  ///< at the newest scan
    Pose sensorInOdom = Pose::Identity();
    int odometryFrame = -1;                           ///< negative: of an earlier run of the station
    bool odometry = false;                            ///< whether sensorInOdom was measured
    bool lost = false;                                ///< the newest scan did not fit
    bool contradicted = false;                        ///< nor does what is known about it: odometry erred
    bool waited = false;                              ///< ... was left out for the next one
    double certainty = 0.0;                           ///< RobotFix::certainty
    std::uint8_t doubts = 0;                          ///< of the newest scan
    double way = 0.0, turn = 0.0;                     ///< since a scan was certain [m, rad]
    double openWay = 0.0;                             ///< since surfaces held all directions [m]
    Eigen::Vector3d moved = Eigen::Vector3d::Zero();  ///< Step::moved
    OdometryScale scale;                              ///< of the odometry's way
    SpinningWheels wheels;
    RangeBias rangeBias;
    ScannerLean lean;
    ScannerMount mount;
    Pose mountAt = Pose::Identity();   ///< the scan that told of the mount last, as it was then in the map
    std::uint64_t calibrated = 0;      ///< the scanner is as it is now from the scan after this id on
    std::size_t comparisons = 0;       ///< of key scans since, for RangeBias, whether they told or not
    std::uint64_t compared = 0;        ///< id of the scan that key scans were compared with last ...
    int comparedAgain = 0;             ///< ... and how often it was
    Pose leanAt = Pose::Identity();    ///< the scan that told of the lean last, as it was then in the map
    Pose keyInMap = Pose::Identity();  ///< newest key scan
    std::uint64_t key = 0;             ///< its id; 0: none of this run
    Pose unspun = Pose::Identity();    ///< LiveKeyScan::unspun, now
    std::optional<Pose> placedInMap;   ///< base_link, by the operator, for the next scan
    bool beginsPart = false;           ///< with its next scan, unless it is known where it is
};

/// Insides of LiveMapper.
struct LiveMapper::State {
    State(std::string name, LiveSettings chosen)
        : station(std::move(name)),
          settings(std::move(chosen)),
          uncropped(settings),
          clouds(settings.pages, settings.inMemory),
          loops(settings.loops, settings.match, settings.fit) {
        uncropped.crop = {};
        cropped.setCrop(settings.crop);
    }

    [[nodiscard]] Pose guessOf(const LiveScan& live, const RobotTrack& robot, Step& step) const;
    /// The scans about @p place that @p robot's newest scans hang together with.
    [[nodiscard]] const LocalMap& localAt(const Pose& place, const RobotTrack& robot);
    /// Links of the newest key scan, which was matched with @p against, and what closes at it.
    void link(MapUpdate& update, const RobotTrack& robot, std::span<const std::uint64_t> against,
              const Match& match, Time now);
    [[nodiscard]] Match matched(const LiveScan& live, const RobotTrack& robot, const PointCloud& cloud,
                                const Pose& guess, const Step& step);
    /// Takes the drift within the turn out of @p ready, where that lets it fit better than @p match says.
    void refine(const LiveScan& live, const RobotTrack& robot, const Pose& guess, const Step& step,
                std::span<const PlacedBody> others, ReadyScan& ready, Match& match);
    /// @p live, which does not fit, or elsewhere than where odometry has it, was put together as if the robot
    /// had moved as its wheels did: where it fits, or fits better, to where the robot was last, put together
    /// as if that only turned, the wheels spun.
    void stand(const LiveScan& live, const RobotTrack& robot, const Pose& guess, const Step& step,
               std::span<const PlacedBody> others, ReadyScan& ready, Match& match);
    /// Whether @p live, which does not fit, was taken where odometry says, at @p guess: it sees ground that
    /// is new, and neither fills what scans about it looked through, nor do these.
    [[nodiscard]] bool isHeldByOdometry(const LiveScan& live, const RobotTrack& robot, const ReadyScan& ready,
                                        const Pose& guess, const Step& step);
    /// What @p live says is against gravity, as far as its scanner's lean is known.
    [[nodiscard]] static Eigen::Vector3d upOf(const LiveScan& live, const RobotTrack& robot);
    [[nodiscard]] bool enters(const RobotTrack& robot, const Pose& scanInMap, double fresh) const;
    /// Whether the map can do without this scan, if the next one enters.
    [[nodiscard]] bool canWait(const RobotTrack& robot, const Pose& scanInMap, double fresh) const;
    /// @p live, which fits as @p match says, tells how its scanner leans.
    void lean(RobotTrack& robot, const LiveScan& live, const Match& match, double way) const;
    /// @p live, which came to lie at @p scanInMap, tells how its scanner sits, where @p fits: odometry and
    /// surfaces tell how the robot came there.
    static void tellMount(RobotTrack& robot, const LiveScan& live, const Pose& scanInMap, bool fits);
    [[nodiscard]] bool empty() const;  ///< nothing counts
    /// Where a scan that looks upwards by @p up begins a part of its own.
    [[nodiscard]] Pose aside(const Eigen::Vector3d& up) const;
    [[nodiscard]] std::vector<ScanInPart> scansInParts() const;
    void findParts();  ///< which part each scan is of, by the links as they are
    /// Whether nothing counts of the part that @p robot, which nobody has put anywhere, is in.
    [[nodiscard]] bool isAlone(const RobotTrack& robot);
    /// Whether the next scan of @p robot, if it is whole enough, begins a part beside those that are there:
    /// also of a robot whose part is no more, since all of it was set aside.
    [[nodiscard]] bool beginsPart(const RobotTrack& robot);
    /// Of the next scan of @p robot, which is looked for about @p guess.
    [[nodiscard]] std::uint64_t partFor(const RobotTrack& robot, const Pose& guess);
    [[nodiscard]] std::uint64_t partOf(const RobotTrack& robot);
    /// For the next scan of @p robot, which is looked for about @p guess.
    [[nodiscard]] const LiveSettings& preparing(const RobotTrack& robot, const Pose& guess);
    /// What @p entered, of which @p cloud is matched, tells of its scanner.
    void calibrate(RobotTrack& robot, const LiveKeyScan& entered, const PointCloud& cloud);
    /// Whether the newest scan of @p robot that is not set aside is uncertain.
    [[nodiscard]] bool awaitsDecision(const std::string& robot) const;
    /// When a scan enters that came to be registered @p now: scans of one batch differ in it.
    [[nodiscard]] Time entering(Time now);
    [[nodiscard]] LiveKeyScan* find(std::uint64_t id);
    /// Puts scans to where and how @p poses say, and robots along with them.
    void apply(std::span<const ScanPose> poses);
    /// The scan @p id was registered again, against @p against: what was known of it before is no more.
    void linkAgain(std::uint64_t id, std::span<const std::uint64_t> against, const Match& match, Time now);
    /// Of all links, as they are now, or as @p instead has them.
    [[nodiscard]] MapProblem problem(std::span<const Link> instead) const;
    [[nodiscard]] ScanPosesSample decided(std::vector<ScanPose> poses, Time now);
    void goOn(const std::string& robot);
    /// What is matched of @p key, whose scan is whole yet, of the points @p reduced.
    [[nodiscard]] MatchedCloudPtr matchedOf(LiveKeyScan& key, const PointCloud& reduced) const;
    /// Likewise, made when it is used first.
    [[nodiscard]] MatchedCloudPtr promised(LiveKeyScan& key) const;

    std::string station;
    LiveSettings settings;
    LiveSettings uncropped;  ///< the same, of parts of which nobody knows how they lie to the area
    std::map<std::string, RobotTrack> robots;
    LiveMap map;
    MatchedClouds clouds;  ///< of the map's scans
    CroppedScans cropped;  ///< what of its scans is in the map
    LoopCloser loops;
    std::uint64_t revision =
        0;  ///< of what solutions are for: decisions, and what other stations say, change it
    std::optional<ScanLinksSample> madeLinks;  ///< by the newest decision
    bool unsolved = false;                     ///< since a loop closed or was taken back
    std::deque<std::uint64_t> meeting;         ///< scans of parts that came together, for meetMore()
    std::uint64_t sought = 0;      ///< newest scan that is to be looked for in the whole map; 0: none
    bool soughtElsewhere = false;  ///< the last one, in other parts
    std::uint64_t nextId = 1;
    Time entered{};  ///< the newest scan
    LocalMap local;
    Pose localPlace = Pose::Identity();
    std::uint64_t localKey = 0;  ///< of the robot that it is for
    bool localStale = true;
};

}  // namespace leitstand
