#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "core/mapping/graph/pose_graph.h"

namespace leitstand {

/// The links between a map's key scans, and which scans hang together by them over how much way.
class ScanGraph {
public:
    /// Takes @p link in. One without an id gets the next; one whose id is known takes the place of that one.
    const Link& add(Link link);
    /// Whether poses follow the link @p id.
    void setActive(std::uint64_t id, bool active);
    /// Takes the scan @p id out, with all its links.
    void forget(std::uint64_t id);
    /// The links @p ids are as good as not active, whatever they say, until this is said anew
    /// (unheldLoops()).
    void setUnheld(std::set<std::uint64_t> ids);
    /// Ids of links that come later begin with the next @p block: another station numbers some, too.
    void beginBlock(std::uint64_t block);

    /// The scans that can be reached from @p id over at most @p most [m] of active links, itself included,
    /// with that way; links of odometry count twice. What was registered against each other is nearly
    /// certain to each other; what lies side by side and is far from each other over the graph is not.
    [[nodiscard]] std::map<std::uint64_t, double> within(std::uint64_t id, double most) const;
    /// The least sum of @p cost over active links from @p from to @p to; empty: they do not hang together.
    [[nodiscard]] std::optional<double> cheapest(std::uint64_t from, std::uint64_t to,
                                                 const std::function<double(const Link&)>& cost) const;
    [[nodiscard]] const std::vector<Link>& links() const { return m_links; }  ///< by rising id

private:
    struct Edge {
        std::uint64_t to = 0;
        double distance = 0.0;
        std::uint64_t link = 0;
    };
    /// Goes from scan to scan, the cheapest first, while @p reached(scan, sum) wants more (Dijkstra 1959).
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
