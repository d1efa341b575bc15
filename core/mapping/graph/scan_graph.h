#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "core/mapping/graph/pose_graph.h"

namespace leitstand {

/// The links between a map's key scans: which scans they connect, and over what distance.
class ScanGraph {
public:
    /// Adds @p link. If its id is 0, it gets the next one. If its id is known, it replaces the link of that
    /// id.
    const Link& add(Link link);
    /// Sets whether poses follow the link @p id.
    void setActive(std::uint64_t id, bool active);
    /// Removes the scan @p id with all its links.
    void forget(std::uint64_t id);
    /// Treats the links @p ids as not active, whatever Link::active says (unheldLoops()). The next call
    /// replaces @p ids.
    void setUnheld(std::set<std::uint64_t> ids);
    /// Gives later links ids above the next multiple of @p block, since another station numbers links too.
    void beginBlock(std::uint64_t block);

    /// Returns the scans that can be reached from @p id over at most @p most [m] of active links, each with
    /// that distance; @p id itself is included. Links of odometry count twice their length. The relative pose
    /// of scans that were registered against each other is nearly certain. That of scans side by side that
    /// are far from each other over the graph is not.
    [[nodiscard]] std::map<std::uint64_t, double> within(std::uint64_t id, double most) const;
    /// Returns the least sum of @p cost over active links from @p from to @p to; empty: the two are not
    /// connected.
    [[nodiscard]] std::optional<double> cheapest(std::uint64_t from, std::uint64_t to,
                                                 const std::function<double(const Link&)>& cost) const;
    [[nodiscard]] const std::vector<Link>& links() const { return m_links; }  ///< by rising id

private:
    struct Edge {
        std::uint64_t to = 0;
        double distance = 0.0;
        std::uint64_t link = 0;
    };
    /// Visits scans from @p from on, the cheapest first, while reached(scan, sum) returns true (Dijkstra
    /// 1959).
    template <class Cost, class Reached>
    void walk(std::uint64_t from, double most, const Cost& cost, const Reached& reached) const;
    void connect(const Link& link);
    void disconnect(const Link& link);

    std::map<std::uint64_t, std::vector<Edge>> m_edges;  ///< of active links, by scan
    std::vector<Link> m_links;
    std::set<std::uint64_t> m_unheld;
    std::uint64_t m_next = 1;
};

}  // namespace leitstand
