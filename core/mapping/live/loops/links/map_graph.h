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

/// The links of a growing map, and what follows from them: which scans have certain relative poses, how far
/// the map may err, and where no loop may close.
class MapGraph {
public:
    MapGraph(const LoopSettings& settings, const MatchSettings& match)
        : m_settings(settings), m_match(match) {}

    /// Adds the links of a scan that entered the map, and returns them.
    std::vector<Link> add(const Entry& entry);
    /// Deactivates the match and odometry links of a scan that was registered again, and adds its new links.
    /// Returns all links that changed.
    std::vector<Link> replace(const Entry& entry);
    /// Adds a link that closes a loop, with the next id, and returns it.
    Link add(Link link) { return m_graph.add(std::move(link)); }
    /// Adds links from the log or from another station.
    void restore(std::span<const Link> links);
    /// Sets loop links to their present state. Around a link that is not active, no loop closes automatically
    /// again (wasRefused()). Returns whether links changed that poses follow.
    bool follow(std::span<const Link> loops);
    /// Deactivates the loop links with the ids @p links, which other links contradict, and returns them. No
    /// loop closes around them automatically again (wasRefused()).
    std::vector<Link> contradict(std::span<const std::uint64_t> links);
    /// Sets the ids of active links that poses do not follow all the same: unheldLoops().
    void setUnheld(std::set<std::uint64_t> links) { m_graph.setUnheld(std::move(links)); }
    void forget(std::uint64_t scan) { m_graph.forget(scan); }
    void beginBlock();  ///< lets later link ids begin in a new block, because this station now makes the map

    /// Returns the scans whose poses relative to @p id are nearly certain, with their distance over the graph
    /// [m].
    [[nodiscard]] std::map<std::uint64_t, double> sameAge(std::uint64_t id) const;
    /// Returns the scans near @p id over the graph (LoopSettings::about), with this distance [m]. A scan is
    /// matched with all of them together.
    [[nodiscard]] std::map<std::uint64_t, double> about(std::uint64_t id) const;
    /// Returns the expected error of the relative pose of two scans [m]; infinite: no links connect them.
    [[nodiscard]] double deviation(std::uint64_t from, std::uint64_t to) const;
    /// Returns whether a loop between the surroundings (about()) of @p from and @p to is an open question.
    /// Also true if such a loop was removed, or is contradicted by other links.
    [[nodiscard]] bool wasRefused(std::uint64_t from, std::uint64_t to) const;
    /// Returns whether active links of at most @p most metres in total connect the two scans.
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
