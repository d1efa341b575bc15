#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/loops/links/map_graph.h"
#include "core/mapping/live/loops/places/place_finder.h"
#include "core/mapping/live/loops/places/place_verifier.h"
#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// Finds where the path of robots meets itself. Scans that lie side by side in the map, but far from each
/// other over the graph, are registered against each other. Two such places that agree are a loop.
class LoopCloser {
public:
    /// @p graph and @p places must outlive it.
    LoopCloser(const LoopSettings& settings, MapGraph& graph, const PlaceFinder& places)
        : m_settings(settings), m_graph(graph), m_places(places) {}

    /// Drops the places that wait for others to agree, since scans have moved.
    void moved() { m_pending.clear(); }
    void forget(std::uint64_t scan);

    /// Looks for a loop at the new scan @p entered, which must count. Adds the loop's links to the graph and
    /// returns them; empty: none. If the map would have erred so much that the operator must be asked, the
    /// links are not active.
    [[nodiscard]] std::vector<Link> close(const LiveKeyScan& entered, const LiveMap& map);
    /// Returns whether the scan @p entered, where no loop closed, is to be looked for in the whole map. That
    /// is so at most once per LoopSettings::seekEvery, where the map may err by more than the usual search
    /// covers. While parts have not met, it is so once per LoopSettings::seekPartsEvery.
    [[nodiscard]] bool seeks(const LiveKeyScan& entered, const LiveMap& map);
    /// Returns whether the map may err so much between @p scan and earlier scans of its part that the usual
    /// search misses a loop there.
    [[nodiscard]] bool mayErrFar(const LiveKeyScan& scan, const LiveMap& map) const;
    /// The same as close() for the scan @p entered, which was found at @p scanInMap, far from its pose in the
    /// map. @p verified: whether its whole part, moved with it, was compared with the map there.
    [[nodiscard]] std::vector<Link> closeFar(const LiveKeyScan& entered, const Pose& scanInMap,
                                             const LiveMap& map, bool verified = true);

    /// Checks @p scan after two parts of the map came together because some of their scans agree. If @p scan,
    /// which lies where that puts it, sees what scans of the other part saw, its match is kept for takeMet().
    void meetAt(const LiveKeyScan& scan, const LiveMap& map);
    /// Returns the links of the matches that meetAt() kept, and adds them to the graph. A match counts only
    /// if the next one before or after it on the same robot's path agrees; matches at nearly the same place
    /// are skipped.
    [[nodiscard]] std::vector<Link> takeMet();
    /// Drops the matches that meetAt() kept for takeMet(). Returns the ids of their scans, to be given to
    /// meetAt() again.
    std::vector<std::uint64_t> forgetMet();

private:
    /// Returns the links of @p found and of the kept places that agree with it, if these are enough.
    /// Otherwise keeps @p found for later ones. Links that move the map farther than expected, or of far
    /// places, are not active: a question to the operator.
    [[nodiscard]] std::vector<Link> meet(MatchedPlace found, bool verified);
    /// Returns whether @p found would move the map farther than the map can have erred.
    [[nodiscard]] bool tooFar(const MatchedPlace& found) const;
    [[nodiscard]] bool agree(const MatchedPlace& a, const MatchedPlace& b) const;
    /// Returns whether a question, or a loop that was taken back, would move the map as @p found does.
    [[nodiscard]] bool wasAsked(const MatchedPlace& found, const LiveMap& map) const;

    LoopSettings m_settings;
    MapGraph& m_graph;
    const PlaceFinder& m_places;
    std::vector<MatchedPlace> m_pending;
    std::vector<MatchedPlace> m_met;                ///< of meetAt()
    std::map<std::string, std::uint64_t> m_sought;  ///< newest scan for which seeks() was true, by robot
};

}  // namespace leitstand
