#include "core/mapping/graph/scan_graph.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <set>
#include <utility>

namespace leitstand {
namespace {

constexpr double ByOdometry = 2.0;  ///< links of odometry count as so many times their length: they err more

std::vector<Link>::iterator placeOf(std::vector<Link>& links, std::uint64_t id) {
    return std::lower_bound(links.begin(), links.end(), id,
                            [](const Link& link, std::uint64_t wanted) { return link.id < wanted; });
}

}  // namespace

void ScanGraph::connect(const Link& link) {
    if (!link.active || link.from == link.to || m_unheld.contains(link.id)) return;
    const double factor = link.kind == LinkKind::Odometry ? ByOdometry : 1.0;
    const double distance = factor * link.pose.translation().norm();
    m_edges[link.from].push_back({link.to, distance, link.id});
    m_edges[link.to].push_back({link.from, distance, link.id});
}

void ScanGraph::disconnect(const Link& link) {
    for (const std::uint64_t scan : {link.from, link.to}) {
        const auto edges = m_edges.find(scan);
        if (edges == m_edges.end()) continue;
        std::erase_if(edges->second, [&](const Edge& edge) { return edge.link == link.id; });
        if (edges->second.empty()) m_edges.erase(edges);
    }
}

const Link& ScanGraph::add(Link link) {
    if (link.id == 0) link.id = m_next;
    m_next = std::max(m_next, link.id + 1);
    auto place = placeOf(m_links, link.id);
    if (place != m_links.end() && place->id == link.id) {
        disconnect(*place);
        *place = std::move(link);
    } else {
        place = m_links.insert(place, std::move(link));
    }
    connect(*place);
    return *place;
}

void ScanGraph::setActive(std::uint64_t id, bool active) {
    const auto place = placeOf(m_links, id);
    if (place == m_links.end() || place->id != id || place->active == active) return;
    disconnect(*place);
    place->active = active;
    connect(*place);
}

void ScanGraph::setUnheld(std::set<std::uint64_t> ids) {
    if (ids == m_unheld) return;
    for (const Link& link : m_links) {
        if (m_unheld.contains(link.id) != ids.contains(link.id)) disconnect(link);
    }
    const std::set<std::uint64_t> before = std::exchange(m_unheld, std::move(ids));
    for (const Link& link : m_links) {
        if (before.contains(link.id) && !m_unheld.contains(link.id)) connect(link);
    }
}

void ScanGraph::forget(std::uint64_t id) {
    for (const Link& link : m_links) {
        if (link.from != id && link.to != id) continue;
        disconnect(link);
        m_unheld.erase(link.id);
    }
    std::erase_if(m_links, [id](const Link& link) { return link.from == id || link.to == id; });
}

void ScanGraph::beginBlock(std::uint64_t block) {
    m_next = (m_next - 1 + block) / block * block + 1;
}

std::map<std::uint64_t, double> ScanGraph::within(std::uint64_t id, double most) const {
    std::map<std::uint64_t, double> found;
    walk(
        id, most, [](const Edge& edge) { return edge.distance; },
        [&](std::uint64_t at, double way) {
            found.emplace(at, way);
            return true;
        });
    return found;
}

std::optional<double> ScanGraph::cheapest(std::uint64_t from, std::uint64_t to,
                                          const std::function<double(const Link&)>& cost) const {
    std::optional<double> found;
    const auto of = [&](const Edge& edge) {
        return cost(
            *std::lower_bound(m_links.begin(), m_links.end(), edge.link,
                              [](const Link& link, std::uint64_t wanted) { return link.id < wanted; }));
    };
    walk(from, std::numeric_limits<double>::infinity(), of, [&](std::uint64_t at, double sum) {
        if (at == to) found = sum;
        return !found;
    });
    return found;
}

template <class Cost, class Reached>
void ScanGraph::walk(std::uint64_t from, double most, const Cost& cost, const Reached& reached) const {
    using Place = std::pair<double, std::uint64_t>;
    std::set<std::uint64_t> seen;
    std::priority_queue<Place, std::vector<Place>, std::greater<>> open;
    open.emplace(0.0, from);
    while (!open.empty()) {
        const auto [sum, at] = open.top();
        open.pop();
        if (!seen.insert(at).second) continue;
        if (!reached(at, sum)) return;
        const auto edges = m_edges.find(at);
        if (edges == m_edges.end()) continue;
        for (const Edge& edge : edges->second) {
            const double then = sum + cost(edge);
            if (then <= most && !seen.contains(edge.to)) open.emplace(then, edge.to);
        }
    }
}

}  // namespace leitstand
