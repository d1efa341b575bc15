#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "core/mapping/graph/scan_graph.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/loops/links/found_links.h"

namespace leitstand {

/// The links of a map that grows, and what follows from them: which scans have certain relative poses, how
/// far the map may err, and where no loop may close.
class MapGraph {
public:
    MapGraph(const LoopSettings& settings, const MatchSettings& match)
        : m_settings(settings), m_match(match) {}

    /// Adds the links of a scan that entered the map, and returns them.
    std::vector<Link> add(const Entry& entry);
    /// Deactivates the match and odometry links of a scan that was registered again, and adds its new ones.
    /// Returns all links that changed.
    std::vector<Link> replace(const Entry& entry);
    /// Adds a link that closes a loop, with the next id, and returns it.
    Link add(Link link) { return m_graph.add(std::move(link)); }
    /// Adds links of the log, or of another station.
    void restore(std::span<const Link> links);
    /// Sets links of loops to their present state. Around one that is not active, no loop closes by itself
    /// again (wasRefused()). Returns whether links that poses follow changed.
    bool follow(std::span<const Link> loops);
    /// Deactivates the loop links of ids @p links, which other links contradict, and returns them. No loop
    /// closes around them by itself again (wasRefused()).
    std::vector<Link> contradict(std::span<const std::uint64_t> links);
    /// Sets the ids of the links that poses do not follow, although they are active: unheldLoops().
    void setUnheld(std::set<std::uint64_t> links) { m_graph.setUnheld(std::move(links)); }
    void forget(std::uint64_t scan) { m_graph.forget(scan); }
    void beginBlock();  ///< gives later links ids of a new block: this station takes the map over

    /// Returns the scans whose poses relative to @p id are nearly certain, each with its distance over the
    /// graph [m].
    [[nodiscard]] std::map<std::uint64_t, double> sameAge(std::uint64_t id) const;
    /// Returns the scans near @p id over the graph (LoopSettings::about), each with that distance [m].
    /// Another scan is matched with all of them together.
    [[nodiscard]] std::map<std::uint64_t, double> about(std::uint64_t id) const;
    /// Returns how far the map is expected to err between the two scans [m]; infinite: no links connect them.
    [[nodiscard]] double deviation(std::uint64_t from, std::uint64_t to) const;
    /// Returns whether a loop between the surroundings of @p from and @p to (about()) is an open question.
    /// Also true if one was taken back, or is contradicted by other links.
    [[nodiscard]] bool wasRefused(std::uint64_t from, std::uint64_t to) const;
    /// Returns whether the two scans are connected over at most @p most [m] of active links.
    [[nodiscard]] bool areWithin(std::uint64_t from, std::uint64_t to, double most) const {
        return m_graph.within(from, most).contains(to);
    }
    [[nodiscard]] const std::vector<Link>& links() const { return m_graph.links(); }  ///< by rising id

private:
    LoopSettings m_settings;
    MatchSettings m_match;
    ScanGraph m_graph;
};

}  // namespace leitstand
