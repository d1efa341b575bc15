#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/time.h"
#include "core/event/scan_links.h"
#include "core/event/scan_pose.h"
#include "core/mapping/graph/map_parts.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/loops/hand_links.h"
#include "core/mapping/live/loops/links/map_graph.h"
#include "core/mapping/live/loops/loop_closer.h"
#include "core/mapping/live/loops/places/place_finder.h"
#include "core/mapping/live/map/cropped_scans.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/map/matched_clouds.h"
#include "core/mapping/live/registration/robot_track.h"
#include "core/mapping/live/registration/scan_matcher.h"

namespace leitstand {

/// The map that LiveMapper makes, with its robots: what registration, decisions and links work on together.
struct GrowingMap {
    GrowingMap(std::string name, LiveSettings chosen)
        : station(std::move(name)),
          settings(std::move(chosen)),
          uncropped(settings),
          clouds(settings.pages, settings.inMemory),
          graph(settings.loops, settings.match),
          places(settings.loops, settings.match, settings.fit, graph),
          loops(settings.loops, graph, places),
          byHand(settings.loops, graph, places),
          matcher(map, graph, settings) {
        uncropped.crop = {};
        cropped.setCrop(settings.crop);
    }

    GrowingMap(const GrowingMap&) = delete;  // its parts refer to each other
    GrowingMap& operator=(const GrowingMap&) = delete;

    [[nodiscard]] bool empty() const;                   ///< whether no scan counts
    [[nodiscard]] LiveKeyScan* find(std::uint64_t id);  ///< null: the map has no scan of that id
    [[nodiscard]] std::vector<ScanInPart> scansInParts() const;
    /// Returns LiveKeyScan::part of @p robot's newest key scan. Also 0 if the robot has none, or it is gone.
    [[nodiscard]] std::uint64_t partOf(const RobotTrack& robot);
    void findParts();  ///< sets LiveKeyScan::part of all scans by the present links
    /// Returns whether the newest scan of @p robot that is not set aside is uncertain.
    [[nodiscard]] bool awaitsDecision(const std::string& robot) const;
    /// Returns the time of entry of a scan that is registered @p now. It differs for all scans, also of one
    /// batch.
    [[nodiscard]] Time entering(Time now);
    /// Takes over @p poses, with their trust. A robot moves with its newest key scan.
    void apply(std::span<const ScanPose> poses);
    /// Continues the robot's pose from its newest key scan that is not set aside.
    void goOn(const std::string& robot);
    void linksChanged();  ///< notes that the map has to be solved
    /// Returns the cloud for matching of @p key, made of its points @p reduced. The scan of @p key must still
    /// be whole; it is kept in LiveKeyScan::kept, too.
    [[nodiscard]] MatchedCloudPtr matchedOf(LiveKeyScan& key, const PointCloud& reduced) const;
    /// The same, but the cloud is made of the whole scan on first use.
    [[nodiscard]] MatchedCloudPtr promised(LiveKeyScan& key) const;

    std::string station;
    LiveSettings settings;
    LiveSettings uncropped;  ///< the same without the area, for parts whose pose relative to it is unknown
    std::map<std::string, RobotTrack> robots;
    LiveMap map;
    MatchedClouds clouds;  ///< of the map's scans
    CroppedScans cropped;  ///< which points of the map's scans are in it
    MapGraph graph;        ///< links of the map's scans
    PlaceFinder places;
    LoopCloser loops;
    HandLinks byHand;
    /// Rises with decisions, new loops, and changes by other stations. A solution of an earlier revision is
    /// dropped.
    std::uint64_t revision = 0;
    bool unsolved = false;  ///< whether a loop closed or was taken back since the map was last solved
    std::deque<std::uint64_t> meeting;  ///< scans of parts that came together, for MapLinks::meetMore()
    std::uint64_t sought = 0;           ///< newest scan to be looked for in the whole map; 0: none
    std::uint64_t nextId = 1;
    Time entered{};  ///< time of the newest scan
    ScanMatcher matcher;
};

/// Deactivates those of @p links that poses do not follow (unheldLoops()). Returns their ids.
std::set<std::uint64_t> leaveUnheld(std::vector<Link>& links, std::span<const ScanInPart> scans);

}  // namespace leitstand
