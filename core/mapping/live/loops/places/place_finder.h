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

/// Decides whether a scan near a given pose sees the same as the scans there that are far from it over the
/// graph.
class PlaceFinder {
public:
    using Excluded = std::function<bool(const LiveKeyScan&)>;

    /// @p graph must outlive this object.
    PlaceFinder(const LoopSettings& settings, const MatchSettings& match, const FitSettings& fit,
                const MapGraph& graph)
        : m_settings(settings), m_verifier(settings, match, fit), m_graph(graph) {}

    /// Returns the certain scan nearest to @p guess, within LoopSettings::reach; null: none. Leaves out scans
    /// for which @p excluded is true.
    [[nodiscard]] const LiveKeyScan* nearestTo(const Pose& guess, const LiveMap& map,
                                               const Excluded& excluded) const;
    /// Returns the certain scan nearest to @p guess, within LoopSettings::reach; null: none. Leaves out
    /// @p scan and scans near it over the graph (MapGraph::sameAge()). @p samePart: look only in the part of
    /// the map that @p scan belongs to.
    [[nodiscard]] const LiveKeyScan* olderAt(const LiveKeyScan& scan, const Pose& guess, const LiveMap& map,
                                             bool samePart) const;
    /// Compares @p scan, placed near @p guess, with @p older and the scans around @p older. Leaves out scans
    /// for which @p excluded is true. Returns the place if both saw the same; empty: they did not.
    [[nodiscard]] std::optional<MatchedPlace> look(const LiveKeyScan& scan, const LiveKeyScan& older,
                                                   const Pose& guess, const LiveMap& map,
                                                   const Excluded& excluded) const;
    /// As above. Leaves out @p scan and scans near it over the graph (MapGraph::sameAge()).
    [[nodiscard]] std::optional<MatchedPlace> look(const LiveKeyScan& scan, const LiveKeyScan& older,
                                                   const Pose& guess, const LiveMap& map) const;
    /// As above, with the scan that olderAt() returns. Empty also if there is no such scan, or if
    /// MapGraph::wasRefused().
    [[nodiscard]] std::optional<MatchedPlace> look(const LiveKeyScan& scan, const Pose& guess,
                                                   const LiveMap& map, bool samePart) const;
    /// Returns whether @p scan fits about as well at another place within the expected error of the map. If
    /// so, @p found is not sure.
    [[nodiscard]] bool fitsBeside(const MatchedPlace& found, const LiveKeyScan& scan,
                                  const LiveMap& map) const;

private:
    [[nodiscard]] Excluded connectedWith(const LiveKeyScan& scan) const;
    /// Returns the scans around @p older as one cloud. Leaves out scans for which @p excluded is true.
    [[nodiscard]] LocalMap localAbout(const LiveKeyScan& older, const LiveMap& map,
                                      const Excluded& excluded) const;

    LoopSettings m_settings;
    PlaceVerifier m_verifier;
    const MapGraph& m_graph;
};

}  // namespace leitstand
