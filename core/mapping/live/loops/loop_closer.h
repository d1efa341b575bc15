#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/pose.h"
#include "core/base/result.h"
#include "core/mapping/graph/scan_graph.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/loops/found_links.h"
#include "core/mapping/live/loops/place_verifier.h"
#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// Finds where the path of robots meets itself. Scans that lie side by side in the map, but far from each
/// other over the graph, are registered against each other. Two such places that agree are a loop.
class LoopCloser {
public:
    LoopCloser(const LoopSettings& settings, const MatchSettings& match, const FitSettings& fit);

    /// Adds the links of a scan that entered the map to the graph, and returns them.
    std::vector<Link> add(const Entry& entry);
    /// The same for a scan that was registered again: deactivates its older links. Returns all links that
    /// changed.
    std::vector<Link> replace(const Entry& entry);
    /// Adds links of the log, or of another station.
    void restore(std::span<const Link> links);
    /// Sets links of loops as they are now. Where one is not active, none closes by itself again. Returns
    /// whether links that poses follow changed.
    bool follow(std::span<const Link> loops);
    /// Deactivates loops that others contradict; none closes there by itself again. Returns them as they are
    /// now.
    std::vector<Link> contradict(std::span<const std::uint64_t> links);
    void moved() { m_pending.clear(); }  ///< scans stand elsewhere now
    /// Sets its links that no pose follows: unheldLoops().
    void setUnheld(std::set<std::uint64_t> links) { m_graph.setUnheld(std::move(links)); }
    void forget(std::uint64_t scan);
    void beginBlock();

    /// Returns scans whose poses relative to @p id are nearly certain, with the distance over the graph [m].
    [[nodiscard]] std::map<std::uint64_t, double> sameAge(std::uint64_t id) const;
    /// Looks for a loop at the scan @p entered, which counts. Adds its links to the graph and returns them;
    /// empty: none. They are not active if the map would have erred so much that the operator must be asked.
    [[nodiscard]] std::vector<Link> close(const LiveKeyScan& entered, const LiveMap& map);
    /// Returns whether the scan @p entered, where nothing closed, is to be looked for in the whole map. It is
    /// after a distance since the one before, where the map may err by more than the usual search covers.
    [[nodiscard]] bool seeks(const LiveKeyScan& entered, const LiveMap& map);
    /// Returns whether a scan of the part of @p scan may lie farther from its expected pose than the usual
    /// search covers.
    [[nodiscard]] bool mayErrFar(const LiveKeyScan& scan, const LiveMap& map) const;
    /// The same as close() for a scan found at @p scanInMap, far from where it stands. @p verified: whether
    /// its whole part, moved with it, was compared there.
    [[nodiscard]] std::vector<Link> closeFar(const LiveKeyScan& entered, const Pose& scanInMap,
                                             const LiveMap& map, bool verified = true);

    /// Checks a scan after two parts of the map met where some of their scans agree. @p scan is of the one,
    /// and stands where that puts it. Whether it also sees what the other one saw is kept for takeMet().
    void meetAt(const LiveKeyScan& scan, const LiveMap& map);
    /// Returns links of the scans given to meetAt() since, which are added to the graph. Only those count
    /// that agree with the nearest one before or after on the same robot's path.
    [[nodiscard]] std::vector<Link> takeMet();
    /// Forgets these, and returns their scans, for another meetAt().
    std::vector<std::uint64_t> forgetMet();

    /// Joins two parts of the map: scans of one were taken at about @p scansInMap in the other. Adds links,
    /// active, of those that fit there to the graph, and returns them. None if fewer than
    /// LoopSettings::partsAgree fit.
    [[nodiscard]] std::vector<Link> join(const std::map<std::uint64_t, Pose>& scansInMap, const LiveMap& map);

    /// Links scans that the operator has moved together to about @p scansInMap. Returns links, active, of
    /// those that fit all other scans there but @p left. They are at most LoopSettings::mostByHand, from all
    /// over the moved scans. Empty: none fits.
    [[nodiscard]] std::vector<Link> moveTo(const std::map<std::uint64_t, Pose>& scansInMap,
                                           const std::set<std::uint64_t>& left, const LiveMap& map);

    /// Proposes a loop that the operator shows: @p scan was taken at about @p guess. Adds its link to the
    /// graph as a question, not active, and returns it. Errors, in words: nothing older is near there, or it
    /// does not fit.
    [[nodiscard]] Result<Link> propose(const LiveKeyScan& scan, Pose guess, const LiveMap& map);

    [[nodiscard]] const ScanGraph& graph() const { return m_graph; }

private:
    /// Returns the nearest scan within reach of @p guess that is not connected with @p entered; null: none.
    /// With @p samePart it is of the same part of the map.
    [[nodiscard]] const LiveKeyScan* olderAt(const LiveKeyScan& entered, const Pose& guess,
                                             const LiveMap& map, bool samePart) const;
    /// Returns the nearest scan within reach of @p guess that @p passed does not exclude; null: none.
    template <class Passed>
    [[nodiscard]] const LiveKeyScan* nearestTo(const Pose& guess, const LiveMap& map, Passed passed) const;
    /// Returns the scans around @p older, without those that @p passed excludes from matching.
    template <class Passed>
    [[nodiscard]] LocalMap localAbout(const LiveKeyScan& older, const LiveMap& map, Passed passed) const;
    /// Returns the place if @p entered, roughly at @p guess, sees what @p older and the scans around it saw
    /// that are not connected with @p entered.
    [[nodiscard]] std::optional<MatchedPlace> look(const LiveKeyScan& entered, const LiveKeyScan& older,
                                                   const Pose& guess, const LiveMap& map) const;
    /// The same with olderAt(), unless the operator refused a loop there.
    [[nodiscard]] std::optional<MatchedPlace> look(const LiveKeyScan& entered, const Pose& guess,
                                                   const LiveMap& map, bool samePart) const;
    /// Returns whether @p entered may as well belong elsewhere, as far off as the map may err there.
    [[nodiscard]] bool fitsBeside(const MatchedPlace& found, const LiveKeyScan& entered,
                                  const LiveMap& map) const;
    /// Returns the links of @p found if others agree with it; else keeps it for later ones. Far ones ask.
    [[nodiscard]] std::vector<Link> meet(MatchedPlace found, bool verified);
    /// Returns the largest group of @p fits with about the same @p off, to put before poses in the map.
    [[nodiscard]] std::vector<std::size_t> largestAgreeing(const std::vector<MatchedPlace>& fits,
                                                           const std::vector<Pose>& off) const;
    /// Returns whether the map cannot have erred by so much.
    [[nodiscard]] bool tooFar(const MatchedPlace& found) const;
    [[nodiscard]] bool agree(const MatchedPlace& a, const MatchedPlace& b) const;
    /// Returns how far the map is expected to err from the one scan to the other [m].
    [[nodiscard]] double deviation(std::uint64_t from, std::uint64_t to) const;
    /// Returns whether a question, or a loop that was taken back, would move the map as @p found does.
    [[nodiscard]] bool wasAsked(const MatchedPlace& found, const LiveMap& map) const;
    [[nodiscard]] bool wasRefused(std::uint64_t from, std::uint64_t to) const;

    LoopSettings m_settings;
    MatchSettings m_match;
    PlaceVerifier m_verifier;
    ScanGraph m_graph;
    std::vector<MatchedPlace> m_pending;
    std::vector<MatchedPlace> m_met;                ///< of meetAt()
    std::map<std::string, std::uint64_t> m_sought;  ///< newest scan for which seeks() was true, by robot
};

}  // namespace leitstand
