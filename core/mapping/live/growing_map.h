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
#include "core/mapping/live/loops/loop_closer.h"
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
          loops(settings.loops, settings.match, settings.fit),
          matcher(map, loops, settings) {
        uncropped.crop = {};
        cropped.setCrop(settings.crop);
    }

    GrowingMap(const GrowingMap&) = delete;  // its parts refer to each other
    GrowingMap& operator=(const GrowingMap&) = delete;

    [[nodiscard]] bool empty() const;                   ///< whether no scan counts
    [[nodiscard]] LiveKeyScan* find(std::uint64_t id);  ///< null: it has none of that id
    [[nodiscard]] std::vector<ScanInPart> scansInParts() const;
    /// Returns the part of @p robot's newest key scan; 0: it has none, or that is gone.
    [[nodiscard]] std::uint64_t partOf(const RobotTrack& robot);
    void findParts();  ///< sets the part of each scan, by the links as they are
    /// Returns whether the newest scan of @p robot that is not set aside is uncertain.
    [[nodiscard]] bool awaitsDecision(const std::string& robot) const;
    /// Returns when a scan enters that is registered @p now: scans of one batch differ in it.
    [[nodiscard]] Time entering(Time now);
    /// Sets poses and trust of scans by @p poses, and moves robots with them.
    void apply(std::span<const ScanPose> poses);
    void goOn(const std::string& robot);  ///< from its newest key scan that is not set aside
    void linksChanged();                  ///< there is something to solve
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
    bool unsolved = false;              ///< since a loop closed or was taken back
    std::deque<std::uint64_t> meeting;  ///< scans of parts that came together, for MapLinks::meetMore()
    std::uint64_t sought = 0;           ///< newest scan to be looked for in the whole map; 0: none
    std::uint64_t nextId = 1;
    Time entered{};  ///< time of the newest scan
    ScanMatcher matcher;
};

/// Deactivates those of @p links that no pose follows. Returns their ids.
std::set<std::uint64_t> leaveUnheld(std::vector<Link>& links, std::span<const ScanInPart> scans);

}  // namespace leitstand
