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

/// Finds where the way of robots meets itself: what lies side by side in the map and is far from each other
/// over the graph is registered against each other; two such places that agree are a loop.
class LoopCloser {
public:
    LoopCloser(const LoopSettings& settings, const MatchSettings& match, const FitSettings& fit);

    /// The links of a scan that entered the map, which are taken into the graph.
    std::vector<Link> add(const Entry& entry);
    /// The same for a scan that was registered again: its older links are not active any more. All that
    /// changed.
    std::vector<Link> replace(const Entry& entry);
    /// Links of the log, or another station's.
    void restore(std::span<const Link> links);
    /// Links of loops as they are now. Where one is not active, none closes by itself again. Whether
    /// something changed that poses follow.
    bool follow(std::span<const Link> loops);
    /// Loops that others speak against, likewise; as they are now.
    std::vector<Link> contradict(std::span<const std::uint64_t> links);
    void moved() { m_pending.clear(); }  ///< scans stand elsewhere now
    /// Which of its links nothing follows: unheldLoops().
    void setUnheld(std::set<std::uint64_t> links) { m_graph.setUnheld(std::move(links)); }
    void forget(std::uint64_t scan);
    void beginBlock();

    /// Scans that are nearly certain to lie right to @p id, with the way to them over the graph [m].
    [[nodiscard]] std::map<std::uint64_t, double> sameAge(std::uint64_t id) const;
    /// Looks for a loop at the scan @p entered, which counts; its links where there is one, which are taken
    /// into the graph: not active where the map would have erred so much that the operator is to be asked.
    [[nodiscard]] std::vector<Link> close(const LiveKeyScan& entered, const LiveMap& map);
    /// Whether the scan @p entered, where nothing closed, is to be looked for in the whole map: so much way
    /// after the one before, and where the map may err by more than is looked for anyway.
    [[nodiscard]] bool seeks(const LiveKeyScan& entered, const LiveMap& map);
    /// Whether a scan of the part of @p scan may lie farther from where it is expected than is looked for
    /// anyway.
    [[nodiscard]] bool mayErrFar(const LiveKeyScan& scan, const LiveMap& map) const;
    /// The same as close() for a scan that was found at @p scanInMap, far from where it stands. @p verified:
    /// whether all of its part, moved along, was compared with what is there.
    [[nodiscard]] std::vector<Link> closeFar(const LiveKeyScan& entered, const Pose& scanInMap,
                                             const LiveMap& map, bool verified = true);

    /// Two parts of the map have come together where some of their scans agree: @p scan is of the one, and
    /// lies where it does by that. Whether it sees what the other has seen, too, is kept for takeMet().
    void meetAt(const LiveKeyScan& scan, const LiveMap& map);
    /// Links of the scans that meetAt() was asked about since: of those that agree with the nearest one
    /// before or after along the same robot's way, which are taken into the graph.
    [[nodiscard]] std::vector<Link> takeMet();
    /// Forgets these; their scans, for meetAt() anew.
    std::vector<std::uint64_t> forgetMet();

    /// It is known that scans of one part of the map were taken at about @p scansInMap in another one: the
    /// links of those that fit there, active, which are taken into the graph. None where fewer than
    /// LoopSettings::partsAgree do.
    [[nodiscard]] std::vector<Link> join(const std::map<std::uint64_t, Pose>& scansInMap, const LiveMap& map);

    /// The operator has moved the scans of @p scansInMap together, to about there: links of those that fit
    /// what is there of all others but @p left, active, at most LoopSettings::mostByHand of them, from all
    /// over it. None: none fits.
    [[nodiscard]] std::vector<Link> moveTo(const std::map<std::uint64_t, Pose>& scansInMap,
                                           const std::set<std::uint64_t>& left, const LiveMap& map);

    /// A loop that the operator shows: @p scan was taken at about @p guess. Its link, not active, which is
    /// taken into the graph as a question. Errors, in words: nothing older is about there, or it does not
    /// fit.
    [[nodiscard]] Result<Link> propose(const LiveKeyScan& scan, Pose guess, const LiveMap& map);

    [[nodiscard]] const ScanGraph& graph() const { return m_graph; }

private:
    /// The nearest scan within reach of @p guess that does not hang together with @p entered, and of its part
    /// of the map where @p samePart; null: none.
    [[nodiscard]] const LiveKeyScan* olderAt(const LiveKeyScan& entered, const Pose& guess,
                                             const LiveMap& map, bool samePart) const;
    /// Likewise, of those scans that @p passed leaves over.
    template <class Passed>
    [[nodiscard]] const LiveKeyScan* nearestTo(const Pose& guess, const LiveMap& map, Passed passed) const;
    /// The scans about @p older, without those that @p passed says are not to be matched with.
    template <class Passed>
    [[nodiscard]] LocalMap localAbout(const LiveKeyScan& older, const LiveMap& map, Passed passed) const;
    /// Whether @p entered, roughly at @p guess, sees what @p older and the scans about it have seen that do
    /// not hang together with it.
    [[nodiscard]] std::optional<MatchedPlace> look(const LiveKeyScan& entered, const LiveKeyScan& older,
                                                   const Pose& guess, const LiveMap& map) const;
    /// The same with olderAt(), unless the operator said no there.
    [[nodiscard]] std::optional<MatchedPlace> look(const LiveKeyScan& entered, const Pose& guess,
                                                   const LiveMap& map, bool samePart) const;
    /// Whether @p entered may as well belong elsewhere, as far off as the map may err there.
    [[nodiscard]] bool fitsBeside(const MatchedPlace& found, const LiveKeyScan& entered,
                                  const LiveMap& map) const;
    /// The links of @p found where others agree with it; else it is kept for those to come. Far ones ask.
    [[nodiscard]] std::vector<Link> meet(MatchedPlace found, bool verified);
    /// Which of @p fits lie about alike by @p off, to put before poses in the map: most of them.
    [[nodiscard]] std::vector<std::size_t> largestAgreeing(const std::vector<MatchedPlace>& fits,
                                                           const std::vector<Pose>& off) const;
    /// Whether the map cannot have erred by so much.
    [[nodiscard]] bool tooFar(const MatchedPlace& found) const;
    [[nodiscard]] bool agree(const MatchedPlace& a, const MatchedPlace& b) const;
    /// How far the map is expected to err from the one scan to the other [m].
    [[nodiscard]] double deviation(std::uint64_t from, std::uint64_t to) const;
    /// Whether a question, or what was taken back, would move the map as @p found does.
    [[nodiscard]] bool wasAsked(const MatchedPlace& found, const LiveMap& map) const;
    [[nodiscard]] bool wasRefused(std::uint64_t from, std::uint64_t to) const;

    LoopSettings m_settings;
    MatchSettings m_match;
    PlaceVerifier m_verifier;
    ScanGraph m_graph;
    std::vector<MatchedPlace> m_pending;
    std::vector<MatchedPlace> m_met;                ///< of meetAt()
    std::map<std::string, std::uint64_t> m_sought;  ///< newest scan that seeks() was true of, by robot
};

}  // namespace leitstand
