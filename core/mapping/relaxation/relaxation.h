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

/// How long a map is relaxed.
struct RelaxationSettings {
    int rounds = 6;          ///< at most
    double settled = 0.001;  ///< it is relaxed when no scan moves farther in a round [m]
    std::vector<double> schedule = {0.25, 0.15, 0.07};  ///< of pair distances [m]
    int threads = 0;                                    ///< 0: one per core
};

/// A map whose scans lie as all that overlaps wants them.
struct Relaxation {
    std::vector<GraphNode> nodes;         ///< the scans that are not set aside, by rising id
    std::vector<std::uint64_t> replaced;  ///< ids of match links that those below take the place of
    std::vector<Link> matches;  ///< that hold them, without ids: what each was matched with in the last round
    std::vector<std::uint64_t>
        contradicted;         ///< ids of loops that the others speak against: nothing follows them
    std::size_t matched = 0;  ///< scans that fit what lies about them
    int rounds = 0;
    bool settled = false;  ///< no scan moved farther than RelaxationSettings::settled any more
    double largest = 0.0;  ///< shift of a scan, all rounds together [m]
    double rmsBefore =
        0.0;                ///< distance of the pairs of all scans with what lies about them, first round [m]
    double rmsAfter = 0.0;  ///< likewise, last round [m]
};

/// Matches each scan of @p map that counts with all that lies about it and hangs together with it, whenever
/// it was taken, and moves all scans at once to where these matches want them; then again, until nothing
/// moves (global relaxation: Lu & Milios 1997; Borrmann, Elseberg, Lingemann, Nuechter & Hertzberg 2008). @p
/// links: the map's, of which odometry counts where surfaces leave something open, and what closes loops. The
/// scan of the lowest id stays. The result does not depend on the number of threads. Cancelled: as after the
/// last round that was finished.
[[nodiscard]] Relaxation relax(const LiveMap& map, std::span<const Link> links, const LiveSettings& settings,
                               const RelaxationSettings& how = {}, const Progress& progress = {});

}  // namespace leitstand
