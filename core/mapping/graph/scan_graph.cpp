#include "core/mapping/graph/scan_graph.h"

#include <functional>
#include <queue>
#include <utility>

namespace leitstand {

void ScanGraph::connect(std::uint64_t id, std::uint64_t other, double distance) {
    if (id == other) return;
    m_edges[id].push_back({other, distance});
    m_edges[other].push_back({id, distance});
}

void ScanGraph::add(Link link) {
    link.id = m_links.empty() ? 1 : m_links.back().id + 1;
    m_links.push_back(std::move(link));
}

void ScanGraph::forget(std::uint64_t id) {
    const auto edges = m_edges.find(id);
    if (edges != m_edges.end()) {
        for (const Edge& edge : edges->second) {
            std::erase_if(m_edges[edge.to], [id](const Edge& back) { return back.to == id; });
        }
        m_edges.erase(edges);
    }
    std::erase_if(m_links, [id](const Link& link) { return link.from == id || link.to == id; });
}

std::map<std::uint64_t, double> ScanGraph::within(std::uint64_t id, double most) const {
    using Reached = std::pair<double, std::uint64_t>;
    std::map<std::uint64_t, double> found;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
    open.emplace(0.0, id);
    while (!open.empty()) {
        const auto [way, at] = open.top();
        open.pop();
        if (!found.emplace(at, way).second) continue;
        const auto edges = m_edges.find(at);
        if (edges == m_edges.end()) continue;
        for (const Edge& edge : edges->second) {
            const double then = way + edge.distance;
            if (then <= most && !found.contains(edge.to)) open.emplace(then, edge.to);
        }
    }
    return found;
}

}  // namespace leitstand
