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

/// The implementation of LiveMapper.
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

    /// How a robot's newest scan fits the map, before it is decided whether it enters.
    struct Registered {
        bool first = false, begins = false;  ///< first of a part; of one beside those that exist
        Pose guess = Pose::Identity();
        Step step;
        ReadyScan ready;
        Match match;
        double fresh = 1.0;                  ///< share of its points that see new ground
        std::vector<std::uint64_t> against;  ///< ids of scans that it was matched with, nearest first
        bool held = false;                   ///< it does not fit, but is held by odometry
        bool lost = false;                   ///< it does not fit, nor is it held
        bool pushed = false;                 ///< wasPushed()
    };
    /// Registers @p live. Returns the doubt if it cannot be registered at all: too few points to begin with,
    /// or its robot's pose is unknown.
    [[nodiscard]] std::variant<Registered, ScanDoubt> registered(const LiveScan& live,
                                                                 const RobotTrack& robot,
                                                                 std::span<const PlacedBody> others);
    /// Returns whether @p found is a key scan of @p robot, which remembers whether it was left out for the
    /// next one.
    [[nodiscard]] bool isKeyScan(RobotTrack& robot, const LiveScan& live, const Registered& found) const;
    /// Enters @p found into the map. Adds to @p update what is to be logged.
    void enter(MapUpdate& update, RobotTrack& robot, const LiveScan& live, const Registered& found, Time now);
    /// Updates @p robot's wheels, scanner and pose by @p found.
    void advance(RobotTrack& robot, const LiveScan& live, const Registered& found) const;
    /// Links the newest key scan, which was matched with @p against, and looks for a loop at it.
    void link(MapUpdate& update, const RobotTrack& robot, std::span<const std::uint64_t> against,
              const Match& match, Time now);
    [[nodiscard]] bool enters(const RobotTrack& robot, const Pose& scanInMap, double fresh) const;
    /// Returns whether the map can do without this scan, if the next one enters.
    [[nodiscard]] bool canWait(const RobotTrack& robot, const Pose& scanInMap, double fresh) const;
    [[nodiscard]] bool empty() const;  ///< whether no scan counts
    /// Returns where a scan with the up direction @p up begins a part of its own.
    [[nodiscard]] Pose aside(const Eigen::Vector3d& up) const;
    [[nodiscard]] std::vector<ScanInPart> scansInParts() const;
    void findParts();  ///< sets the part of each scan, by the links as they are
    /// Returns whether no scan counts in the part of @p robot, which nobody has placed.
    [[nodiscard]] bool isAlone(const RobotTrack& robot);
    /// Returns whether the next scan of @p robot, if it is whole enough, begins a part beside those that
    /// exist. Also true if its part is gone, since all of it was set aside.
    [[nodiscard]] bool beginsPart(const RobotTrack& robot);
    /// Returns the part of the next scan of @p robot, which is looked for around @p guess.
    [[nodiscard]] std::uint64_t partFor(const RobotTrack& robot, const Pose& guess);
    [[nodiscard]] std::uint64_t partOf(const RobotTrack& robot);
    /// Returns the settings for the next scan of @p robot, which is looked for around @p guess.
    [[nodiscard]] const LiveSettings& preparing(const RobotTrack& robot, const Pose& guess);
    /// Returns whether the newest scan of @p robot that is not set aside is uncertain.
    [[nodiscard]] bool awaitsDecision(const std::string& robot) const;
    /// Returns when a scan enters that is registered @p now: scans of one batch differ in it.
    [[nodiscard]] Time entering(Time now);
    [[nodiscard]] LiveKeyScan* find(std::uint64_t id);
    /// Sets poses and trust of scans by @p poses, and moves robots with them.
    void apply(std::span<const ScanPose> poses);
    /// Replaces the links of the scan @p id, which was registered again, against @p against.
    void linkAgain(std::uint64_t id, std::span<const std::uint64_t> against, const Match& match, Time now);
    /// Returns the problem of all links, as they are now, or as @p instead has them.
    [[nodiscard]] MapProblem problem(std::span<const Link> instead) const;
    [[nodiscard]] ScanPosesSample decided(std::vector<ScanPose> poses, Time now);
    void goOn(const std::string& robot);
    /// Returns the cloud for matching of @p key, whose scan is still whole, from the points @p reduced.
    [[nodiscard]] MatchedCloudPtr matchedOf(LiveKeyScan& key, const PointCloud& reduced) const;
    /// The same, made on first use.
    [[nodiscard]] MatchedCloudPtr promised(LiveKeyScan& key) const;

    std::string station;
    LiveSettings settings;
    LiveSettings uncropped;  ///< the same, for parts whose pose relative to the area is unknown
    std::map<std::string, RobotTrack> robots;
    LiveMap map;
    MatchedClouds clouds;  ///< of the map's scans
    CroppedScans cropped;  ///< which points of its scans are in the map
    LoopCloser loops;
    /// Revision of the map that solutions are for: decisions, and changes by other stations, raise it.
    std::uint64_t revision = 0;
    std::optional<ScanLinksSample> madeLinks;  ///< by the newest decision
    bool unsolved = false;                     ///< since a loop closed or was taken back
    std::deque<std::uint64_t> meeting;         ///< scans of parts that came together, for meetMore()
    std::uint64_t sought = 0;                  ///< newest scan to be looked for in the whole map; 0: none
    bool soughtElsewhere = false;              ///< whether the last one was, in other parts
    std::uint64_t nextId = 1;
    Time entered{};  ///< time of the newest scan
    ScanMatcher matcher;
};

}  // namespace leitstand
