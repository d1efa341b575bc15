#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/mapping/live/live_mapper.h"
#include "core/mapping/live/loops/loop_closer.h"
#include "core/mapping/live/map/cropped_scans.h"
#include "core/mapping/live/registration/robot_track.h"
#include "core/mapping/live/registration/scan_matcher.h"
#include "core/mapping/live/scan_work.h"

namespace leitstand {

/// Insides of LiveMapper.
struct LiveMapper::State {
    State(std::string name, LiveSettings chosen)
        : station(std::move(name)),
          settings(std::move(chosen)),
          uncropped(settings),
          clouds(settings.pages, settings.inMemory),
          loops(settings.loops, settings.match, settings.fit),
          matcher(map, loops, settings) {
        uncropped.crop = {};
        cropped.setCrop(settings.crop);
    }

    /// How a robot's newest scan lies in the map, before it is decided whether it enters.
    struct Registered {
        bool first = false, begins = false;  ///< of a part; of one beside those that are there
        Pose guess = Pose::Identity();
        Step step;
        ReadyScan ready;
        Match match;
        double fresh = 1.0;                  ///< share of its points that see new ground
        std::vector<std::uint64_t> against;  ///< ids of what it was matched with, nearest first
        bool held = false;                   ///< it does not fit, but is held by odometry
        bool lost = false;                   ///< it does not fit, nor is it held
        bool pushed = false;                 ///< wasPushed()
    };
    /// Of @p live; the doubts that keep it from being registered at all: too few points to begin with, or
    /// nobody knows where its robot is.
    [[nodiscard]] std::variant<Registered, ScanDoubt> registered(const LiveScan& live,
                                                                 const RobotTrack& robot,
                                                                 std::span<const PlacedBody> others);
    /// Whether @p found is a key scan of @p robot, which remembers whether it was left out for the next one.
    [[nodiscard]] bool isKeyScan(RobotTrack& robot, const LiveScan& live, const Registered& found) const;
    /// @p found enters the map: into @p update what there is to be logged.
    void enter(MapUpdate& update, RobotTrack& robot, const LiveScan& live, const Registered& found, Time now);
    /// What @p found tells of @p robot's wheels and scanner, and where it goes on from.
    void advance(RobotTrack& robot, const LiveScan& live, const Registered& found) const;
    /// Links of the newest key scan, which was matched with @p against, and what closes at it.
    void link(MapUpdate& update, const RobotTrack& robot, std::span<const std::uint64_t> against,
              const Match& match, Time now);
    [[nodiscard]] bool enters(const RobotTrack& robot, const Pose& scanInMap, double fresh) const;
    /// Whether the map can do without this scan, if the next one enters.
    [[nodiscard]] bool canWait(const RobotTrack& robot, const Pose& scanInMap, double fresh) const;
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
    ScanMatcher matcher;
};

}  // namespace leitstand
