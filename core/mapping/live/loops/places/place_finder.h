#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "core/base/pose.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/loops/links/map_graph.h"
#include "core/mapping/live/loops/places/place_verifier.h"
#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// Decides whether a scan that lies roughly at a given pose sees the same as scans there that are far from it
/// over the graph.
class PlaceFinder {
public:
    using Excluded = std::function<bool(const LiveKeyScan&)>;

    /// @p graph must outlive it.
    PlaceFinder(const LoopSettings& settings, const MatchSettings& match, const FitSettings& fit,
                const MapGraph& graph)
        : m_settings(settings), m_verifier(settings, match, fit), m_graph(graph) {}

    /// Returns the nearest scan that counts within LoopSettings::reach of @p guess, without those for which
    /// @p excluded is true; null: none.
    [[nodiscard]] const LiveKeyScan* nearestTo(const Pose& guess, const LiveMap& map,
                                               const Excluded& excluded) const;
    /// Returns the nearest scan that counts within LoopSettings::reach of @p guess; null: none. Leaves out
    /// @p scan and those near it over the graph (MapGraph::sameAge()). @p samePart: only scans of the same
    /// part of the map as @p scan.
    [[nodiscard]] const LiveKeyScan* olderAt(const LiveKeyScan& scan, const Pose& guess, const LiveMap& map,
                                             bool samePart) const;
    /// Compares @p scan, roughly at @p guess, with @p older and the scans around that one. Scans for which
    /// @p excluded is true are left out. Returns the place if both saw the same; empty: they did not.
    [[nodiscard]] std::optional<MatchedPlace> look(const LiveKeyScan& scan, const LiveKeyScan& older,
                                                   const Pose& guess, const LiveMap& map,
                                                   const Excluded& excluded) const;
    /// The same. Leaves out @p scan and those near it over the graph (MapGraph::sameAge()).
    [[nodiscard]] std::optional<MatchedPlace> look(const LiveKeyScan& scan, const LiveKeyScan& older,
                                                   const Pose& guess, const LiveMap& map) const;
    /// The same with the scan of olderAt(). Empty also if there is none, or if MapGraph::wasRefused().
    [[nodiscard]] std::optional<MatchedPlace> look(const LiveKeyScan& scan, const Pose& guess,
                                                   const LiveMap& map, bool samePart) const;
    /// Returns whether @p scan fits about as well at another place, no farther off than the map may err
    /// there. Then @p found is not sure.
    [[nodiscard]] bool fitsBeside(const MatchedPlace& found, const LiveKeyScan& scan,
                                  const LiveMap& map) const;

private:
    [[nodiscard]] Excluded connectedWith(const LiveKeyScan& scan) const;
    /// Returns the scans around @p older, without those for which @p excluded is true, as one cloud.
    [[nodiscard]] LocalMap localAbout(const LiveKeyScan& older, const LiveMap& map,
                                      const Excluded& excluded) const;

    LoopSettings m_settings;
    PlaceVerifier m_verifier;
    const MapGraph& m_graph;
};

}  // namespace leitstand
