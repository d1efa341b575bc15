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

/// The map of a LiveMapper, with its robots. Registration, decisions and links share it.
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

    [[nodiscard]] bool empty() const;  ///< whether all scans are set aside, or there are none
    [[nodiscard]] LiveKeyScan* find(std::uint64_t id);  ///< null: the map has no scan with that id
    [[nodiscard]] std::vector<ScanInPart> scansInParts() const;
    /// Returns LiveKeyScan::part of @p robot's newest key scan. 0 when the robot has no such scan, or it was
    /// removed.
    [[nodiscard]] std::uint64_t partOf(const RobotTrack& robot);
    void findParts();  ///< sets LiveKeyScan::part of all scans from the present links
    /// Returns whether the newest scan of @p robot that is not set aside is uncertain.
    [[nodiscard]] bool awaitsDecision(const std::string& robot) const;
    /// Returns the time at which a scan registered @p now enters the map. It is different for each scan, even
    /// within one batch.
    [[nodiscard]] Time entering(Time now);
    /// Sets the poses and trust of the scans to @p poses. Each robot moves with its newest key scan.
    void apply(std::span<const ScanPose> poses);
    /// Continues the pose of @p robot from its newest key scan that is not set aside.
    void goOn(const std::string& robot);
    void linksChanged();  ///< notes that the map has to be solved
    /// Returns the cloud for matching of @p key, made of its points @p reduced. LiveKeyScan::scan must still
    /// have all points. The cloud is also stored in LiveKeyScan::kept.
    [[nodiscard]] MatchedCloudPtr matchedOf(LiveKeyScan& key, const PointCloud& reduced) const;
    /// As matchedOf(), but the cloud is made from the whole scan when it is first used.
    [[nodiscard]] MatchedCloudPtr promised(LiveKeyScan& key) const;

    std::string station;
    LiveSettings settings;
    /// Settings without the map's area, for parts whose pose relative to it is unknown.
    LiveSettings uncropped;
    std::map<std::string, RobotTrack> robots;
    LiveMap map;
    MatchedClouds clouds;  ///< clouds of the map's scans
    CroppedScans cropped;  ///< which points of the scans are inside the map's area
    MapGraph graph;        ///< links between the map's scans
    PlaceFinder places;
    LoopCloser loops;
    HandLinks byHand;
    /// Increases with decisions, new loops, and changes by other stations. A solution that was begun at an
    /// earlier revision is discarded.
    std::uint64_t revision = 0;
    bool unsolved = false;  ///< whether a loop was closed or removed since the map was last solved
    std::deque<std::uint64_t> meeting;  ///< scans of parts that have been joined, for MapLinks::meetMore()
    std::uint64_t sought = 0;           ///< newest scan that shall be looked for in the whole map; 0: none
    std::uint64_t nextId = 1;
    Time entered{};  ///< when the newest scan entered
    ScanMatcher matcher;
};

/// Deactivates those of @p links that poses do not follow (unheldLoops()), and returns their ids.
std::set<std::uint64_t> leaveUnheld(std::vector<Link>& links, std::span<const ScanInPart> scans);

}  // namespace leitstand
