#include "core/mapping/live/loops/links/map_graph.h"

#include <algorithm>
#include <limits>

namespace leitstand {
namespace {

constexpr std::uint64_t LinkBlock = 100'000;  ///< of link ids, for stations that do not hear each other

}  // namespace

std::vector<Link> MapGraph::add(const Entry& entry) {
    std::vector<Link> links = linksOf(entry, m_settings, m_match);
    for (Link& link : links) link = m_graph.add(std::move(link));
    return links;
}

std::vector<Link> MapGraph::replace(const Entry& entry) {
    std::vector<Link> changed;
    for (const Link& link : m_graph.links()) {
        const bool old = link.kind == LinkKind::Match || link.kind == LinkKind::Odometry;
        if (old && link.active && (link.from == entry.scan.id || link.to == entry.scan.id)) {
            changed.push_back(link);
            changed.back().active = false;
        }
    }
    for (const Link& link : changed) m_graph.setActive(link.id, false);
    std::vector<Link> made = add(entry);
    changed.insert(changed.end(), made.begin(), made.end());
    return changed;
}

void MapGraph::restore(std::span<const Link> links) {
    for (const Link& link : links) m_graph.add(link);
}

bool MapGraph::follow(std::span<const Link> loops) {
    bool changed = false;
    for (const Link& link : loops) {
        const auto known = std::find_if(m_graph.links().begin(), m_graph.links().end(),
                                        [&](const Link& one) { return one.id == link.id; });
        const bool was = known != m_graph.links().end() && known->active;
        changed = changed || was != link.active;
        m_graph.add(link);
    }
    return changed;
}

std::vector<Link> MapGraph::contradict(std::span<const std::uint64_t> links) {
    for (const std::uint64_t id : links) m_graph.setActive(id, false);
    std::vector<Link> contradicted;
    for (const Link& link : m_graph.links()) {
        if (std::find(links.begin(), links.end(), link.id) != links.end()) contradicted.push_back(link);
    }
    return contradicted;
}

void MapGraph::beginBlock() {
    m_graph.beginBlock(LinkBlock);
}

std::map<std::uint64_t, double> MapGraph::sameAge(std::uint64_t id) const {
    return m_graph.within(id, m_settings.sameAge);
}

std::map<std::uint64_t, double> MapGraph::about(std::uint64_t id) const {
    return m_graph.within(id, m_settings.about);
}

double MapGraph::deviation(std::uint64_t from, std::uint64_t to) const {
    const auto way = m_graph.cheapest(from, to, [this](const Link& link) {
        const double share = link.kind == LinkKind::Odometry ? m_settings.openDrift : m_settings.drift;
        return share * link.pose.translation().norm();
    });
    // A scan that is not connected may be anywhere.
    return way ? m_settings.driftAtLeast + *way : std::numeric_limits<double>::infinity();
}

bool MapGraph::wasRefused(std::uint64_t from, std::uint64_t to) const {
    return std::any_of(m_graph.links().begin(), m_graph.links().end(), [&](const Link& link) {
        if (link.active || !closesLoop(link.kind)) return false;
        const auto aboutFrom = about(link.from);
        const auto aboutTo = about(link.to);
        return (aboutFrom.contains(from) && aboutTo.contains(to)) ||
               (aboutFrom.contains(to) && aboutTo.contains(from));
    });
}

}  // namespace leitstand
