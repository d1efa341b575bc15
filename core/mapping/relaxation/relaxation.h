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
    double settled = 0.001;  ///< the map is relaxed when no scan moves farther than this in a round [m]
    std::vector<double> schedule = {0.25, 0.15, 0.07};  ///< largest pair distance of each ICP stage [m]
    int threads = 0;                                    ///< number of threads; 0: one per core
};

/// A map in which each scan fits all that overlaps with it.
struct Relaxation {
    std::vector<GraphNode> nodes;         ///< scans that are not set aside, by rising id
    std::vector<std::uint64_t> replaced;  ///< ids of the match links that `matches` replaces
    std::vector<Link> matches;  ///< links without ids that hold the scans: matches of the last round
    std::vector<std::uint64_t>
        contradicted;         ///< ids of loops that the other links contradict: poses do not follow them
    std::size_t matched = 0;  ///< number of scans that fit their surroundings
    int rounds = 0;
    /// Whether no scan moved farther than RelaxationSettings::settled in the last round.
    bool settled = false;
    double largest = 0.0;  ///< largest shift of a scan over all rounds [m]
    /// Root mean square distance of scans from their surroundings in the first round [m].
    double rmsBefore = 0.0;
    double rmsAfter = 0.0;  ///< the same in the last round [m]
};

/// Fits all scans of @p map to each other at once (global relaxation: Lu & Milios 1997; Borrmann, Elseberg,
/// Lingemann, Nuechter & Hertzberg 2008). Each certain scan is matched with all scans around it that are
/// connected with it, no matter when they were taken. Then all scans move to where these matches fit best.
/// Both steps are repeated until no scan moves.
/// @p links: those of the map. Its loops are used, and its odometry where surfaces leave a direction open. In
/// each part of the map, the scan with the lowest id stays. The result does not depend on the number of
/// threads. Cancelled: the state after the last complete round.
[[nodiscard]] Relaxation relax(const LiveMap& map, std::span<const Link> links, const LiveSettings& settings,
                               const RelaxationSettings& how = {}, const Progress& progress = {});

}  // namespace leitstand
