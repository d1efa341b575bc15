#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/event/scan_links.h"
#include "core/mapping/graph/pose_graph.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// Settings of relax().
struct RelaxationSettings {
    int rounds = 6;          ///< largest number of rounds
    double settled = 0.001;  ///< the map is relaxed when no scan moves farther in a round [m]
    std::vector<double> schedule = {0.25, 0.15, 0.07};  ///< largest pair distance of each ICP stage [m]
    int threads = 0;                                    ///< 0: one per core
};

/// A map whose scans fit everything that overlaps with them.
struct Relaxation {
    std::vector<GraphNode> nodes;         ///< the scans that are not set aside, by rising id
    std::vector<std::uint64_t> replaced;  ///< ids of match links that `matches` replaces
    std::vector<Link> matches;  ///< links that hold the scans, without ids: matches of the last round
    std::vector<std::uint64_t>
        contradicted;         ///< ids of loops that the others contradict: no pose follows them
    std::size_t matched = 0;  ///< scans that fit their surroundings
    int rounds = 0;
    bool settled = false;    ///< no scan moved farther than RelaxationSettings::settled in the last round
    double largest = 0.0;    ///< largest shift of a scan over all rounds [m]
    double rmsBefore = 0.0;  ///< root mean square distance of scans to their surroundings, first round [m]
    double rmsAfter = 0.0;   ///< the same in the last round [m]
};

/// Fits all scans of @p map to each other at once (global relaxation: Lu & Milios 1997; Borrmann, Elseberg,
/// Lingemann, Nuechter & Hertzberg 2008). Each scan that counts is matched with all scans around it that are
/// connected with it, whenever they were taken. Then all scans move to where these matches fit best. Both are
/// repeated until nothing moves.
/// @p links: those of the map. Its loops count, and so does odometry where surfaces leave a direction open.
/// In each part of the map, the scan with the lowest id stays. The result does not depend on the number of
/// threads. Cancelled: the state after the last complete round.
[[nodiscard]] Relaxation relax(const LiveMap& map, std::span<const Link> links, const LiveSettings& settings,
                               const RelaxationSettings& how = {}, const Progress& progress = {});

}  // namespace leitstand
