#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "core/base/pose.h"
#include "core/base/result.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/loops/links/map_graph.h"
#include "core/mapping/live/loops/places/place_finder.h"
#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// Makes links from what the operator shows: a loop, a part of the map that was moved, or two parts that
/// belong together. Links are added to the graph where scans fit.
class HandLinks {
public:
    /// @p graph and @p places must outlive this object.
    HandLinks(const LoopSettings& settings, MapGraph& graph, const PlaceFinder& places)
        : m_settings(settings), m_graph(graph), m_places(places) {}

    /// Joins two parts of the map. @p scansInMap: about where scans of one part lie on the other part, in the
    /// map, by scan id. Adds an active link to the graph for each scan that fits there, and returns these
    /// links. If fewer than LoopSettings::partsAgree fit, returns nothing and leaves the graph as it was.
    [[nodiscard]] std::vector<Link> join(const std::map<std::uint64_t, Pose>& scansInMap, const LiveMap& map);

    /// Links scans that the operator has moved together to about @p scansInMap (by id). They are matched with
    /// all other scans there, except @p left. Adds active links of scans that fit and agree to the graph, and
    /// returns these links: at most LoopSettings::mostByHand, spread over the moved scans. Empty: too few fit
    /// and agree.
    [[nodiscard]] std::vector<Link> moveTo(const std::map<std::uint64_t, Pose>& scansInMap,
                                           const std::set<std::uint64_t>& left, const LiveMap& map);

    /// Proposes a loop that the operator shows: @p scan was taken at about @p guess. Adds its link to the
    /// graph as a question, not active, and returns it. The error says why not: there is nothing older
    /// nearby, or the scan does not fit.
    [[nodiscard]] Result<Link> propose(const LiveKeyScan& scan, Pose guess, const LiveMap& map);

private:
    /// Returns the indices of the largest group of @p fits that agree about @p off. @p off: for each fit, the
    /// correction from where the scan was put to where it fits, applied before poses in the map.
    [[nodiscard]] std::vector<std::size_t> largestAgreeing(const std::vector<MatchedPlace>& fits,
                                                           const std::vector<Pose>& off) const;

    LoopSettings m_settings;
    MapGraph& m_graph;
    const PlaceFinder& m_places;
};

}  // namespace leitstand
