#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "core/mapping/graph/pose_graph.h"

namespace leitstand {

/// What key scans were registered against each other: which of them hang together over how much way, and the
/// links that hold their poses.
class ScanGraph {
public:
    /// Scan @p id was registered against @p other, @p distance [m] away.
    void connect(std::uint64_t id, std::uint64_t other, double distance);
    void add(Link link);
    /// Takes @p id out, with all its links.
    void forget(std::uint64_t id);

    /// The scans that can be reached from @p id over at most @p most [m] of way from scan to scan, itself
    /// included, with that way. What was registered against each other is nearly certain to each other; what
    /// lies side by side and is far from each other over the graph is not.
    [[nodiscard]] std::map<std::uint64_t, double> within(std::uint64_t id, double most) const;
    [[nodiscard]] const std::vector<Link>& links() const { return m_links; }

private:
    struct Edge {
        std::uint64_t to = 0;
        double distance = 0.0;
    };
    std::map<std::uint64_t, std::vector<Edge>> m_edges;
    std::vector<Link> m_links;
};

}  // namespace leitstand
