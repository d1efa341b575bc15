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
    /// Adds @p link. If its id is 0, it gets the next id. If its id is known, it replaces the link with that
    /// id.
    const Link& add(Link link);
    /// Sets whether the link @p id is active: whether poses follow it.
    void setActive(std::uint64_t id, bool active);
    /// Removes the scan @p id with all its links.
    void forget(std::uint64_t id);
    /// Treats the links @p ids as not active, even if Link::active is true (unheldLoops()). The next call
    /// replaces @p ids.
    void setUnheld(std::set<std::uint64_t> ids);
    /// Makes later links begin above the next multiple of @p block, because another station also numbers
    /// links.
    void beginBlock(std::uint64_t block);

    /// Returns the scans that can be reached from @p id over at most @p most metres of active links, each
    /// with its distance. @p id itself is included. Odometry links count with twice their length. If two
    /// scans are near each other over the graph, their relative pose is nearly certain. If they are side by
    /// side but far apart over the graph, it is not.
    [[nodiscard]] std::map<std::uint64_t, double> within(std::uint64_t id, double most) const;
    /// Returns the least sum of @p cost over active links on a way from @p from to @p to. Empty: the two are
    /// not connected.
    [[nodiscard]] std::optional<double> cheapest(std::uint64_t from, std::uint64_t to,
                                                 const std::function<double(const Link&)>& cost) const;
    [[nodiscard]] const std::vector<Link>& links() const { return m_links; }  ///< by rising id

private:
    struct Edge {
        std::uint64_t to = 0;
        double distance = 0.0;
        std::uint64_t link = 0;
    };
    /// Visits scans in the order of their cost from @p from on, as long as reached(scan, sum) returns true
    /// (Dijkstra 1959).
    template <class Cost, class Reached>
    void walk(std::uint64_t from, double most, const Cost& cost, const Reached& reached) const;
    void connect(const Link& link);
    void disconnect(const Link& link);

    std::map<std::uint64_t, std::vector<Edge>> m_edges;  ///< edges of active links, by scan
    std::vector<Link> m_links;
    std::set<std::uint64_t> m_unheld;
    std::uint64_t m_next = 1;
};

}  // namespace leitstand
