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

/// Finds where the paths of robots return to a place. Scans are registered against each other if they lie
/// side by side in the map, but far apart over the graph. Two such places that agree are a loop.
class LoopCloser {
public:
    /// @p graph and @p places must outlive this object.
    LoopCloser(const LoopSettings& settings, MapGraph& graph, const PlaceFinder& places)
        : m_settings(settings), m_graph(graph), m_places(places) {}

    /// Forgets the places that wait for others to agree, because scans have moved.
    void moved() { m_pending.clear(); }
    void forget(std::uint64_t scan);

    /// Looks for a loop at the new scan @p entered, which must not be set aside or uncertain. Adds the loop's
    /// links to the graph and returns them; empty: none. If the map would move so far that the operator must
    /// be asked, the links are not active.
    [[nodiscard]] std::vector<Link> close(const LiveKeyScan& entered, const LiveMap& map);
    /// Returns whether the scan @p entered, where no loop was closed, shall be looked for in the whole map.
    /// This is only so where the map may err by more than the usual search covers, and once per
    /// LoopSettings::seekEvery. While parts of the map are not joined, it is once per
    /// LoopSettings::seekPartsEvery.
    [[nodiscard]] bool seeks(const LiveKeyScan& entered, const LiveMap& map);
    /// Returns whether the expected error between @p scan and earlier scans of its part is so large that the
    /// usual search would miss a loop.
    [[nodiscard]] bool mayErrFar(const LiveKeyScan& scan, const LiveMap& map) const;
    /// As close(), for a scan @p entered that was found at @p scanInMap, far from its pose in the map.
    /// @p verified: whether its whole part was moved there and compared with the map.
    [[nodiscard]] std::vector<Link> closeFar(const LiveKeyScan& entered, const Pose& scanInMap,
                                             const LiveMap& map, bool verified = true);

    /// Checks @p scan after two parts of the map were joined because some of their scans agree. If @p scan
    /// sees there what scans of the other part saw, its match is kept for takeMet().
    void meetAt(const LiveKeyScan& scan, const LiveMap& map);
    /// Returns the links of the matches that meetAt() kept, and adds them to the graph. A match is only used
    /// if the match before or after it on the same robot's path agrees. Of matches at nearly the same place,
    /// one is used.
    [[nodiscard]] std::vector<Link> takeMet();
    /// Forgets the matches that meetAt() kept for takeMet(). Returns the ids of their scans, so that these
    /// can be passed to meetAt() again.
    std::vector<std::uint64_t> forgetMet();

private:
    /// Returns the links of @p found and of the kept places that agree with it, if there are enough.
    /// Otherwise keeps @p found to compare it with later places. Links are a question to the operator (not
    /// active) if they move the map farther than expected, or if the place is far.
    [[nodiscard]] std::vector<Link> meet(MatchedPlace found, bool verified);
    /// Returns whether @p found would move the map farther than its expected error allows.
    [[nodiscard]] bool tooFar(const MatchedPlace& found) const;
    [[nodiscard]] bool agree(const MatchedPlace& a, const MatchedPlace& b) const;
    /// Returns whether the operator was asked already: an open question or a removed loop would move the map
    /// as @p found does.
    [[nodiscard]] bool wasAsked(const MatchedPlace& found, const LiveMap& map) const;

    LoopSettings m_settings;
    MapGraph& m_graph;
    const PlaceFinder& m_places;
    std::vector<MatchedPlace> m_pending;
    std::vector<MatchedPlace> m_met;                ///< matches kept by meetAt()
    std::map<std::string, std::uint64_t> m_sought;  ///< newest scan of each robot for which seeks() was true
};

}  // namespace leitstand
