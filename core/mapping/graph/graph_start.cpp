#include "core/mapping/graph/graph_start.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace leitstand {
namespace {

/// Returns the rank of links of @p kind; lower is surer.
int rankOf(LinkKind kind) {
    switch (kind) {
        case LinkKind::Match:
            return 0;
        case LinkKind::Operator:
            return 1;
        case LinkKind::Odometry:
            return 2;
        case LinkKind::Loop:
        case LinkKind::Session:
            return 3;
        case LinkKind::Gravity:
        case LinkKind::Geo:
            break;
    }
    return 4;
}

/// By node, the place of the node that it follows over single links and that stays.
using Roots = std::vector<std::size_t>;

/// Returns the surest link between the two earliest parts of @p graph that a link joins; null: none.
const Link* joining(const PoseGraph& graph, const std::unordered_map<std::uint64_t, std::size_t>& places,
                    const Roots& roots) {
    const Link* best = nullptr;
    const auto order = [&](const Link& link) {
        const std::size_t a = roots[places.at(link.from)], b = roots[places.at(link.to)];
        return std::tuple(std::min(a, b), std::max(a, b), rankOf(link.kind), link.id);
    };
    for (const Link& link : graph.links) {
        const auto from = places.find(link.from), to = places.find(link.to);
        if (!link.active || from == places.end() || to == places.end()) continue;
        const std::size_t a = roots[from->second], b = roots[to->second];
        if (a == b || graph.nodes[std::max(a, b)].fixed) continue;
        if (best == nullptr || order(link) < order(*best)) best = &link;
    }
    return best;
}

}  // namespace

void startFromLinks(PoseGraph& graph) {
    std::unordered_map<std::uint64_t, std::size_t> places;
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) places.emplace(graph.nodes[i].id, i);
    std::vector<const Link*> surest(graph.nodes.size(), nullptr);
    for (const Link& link : graph.links) {
        const auto from = places.find(link.from), to = places.find(link.to);
        if (!link.active || from == places.end() || to == places.end() || from == to) continue;
        const Link*& best = surest[std::max(from->second, to->second)];
        if (best == nullptr || rankOf(link.kind) < rankOf(best->kind)) best = &link;
    }
    Roots roots(graph.nodes.size());
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        const Link* const link = surest[i];
        roots[i] = i;
        if (link == nullptr || graph.nodes[i].fixed) continue;
        const std::size_t from = places.at(link->from), to = places.at(link->to);
        graph.nodes[i].pose =
            to == i ? graph.nodes[from].pose * link->pose : graph.nodes[to].pose * link->pose.inverse();
        roots[i] = roots[to == i ? from : to];
    }
    while (const Link* const link = joining(graph, places, roots)) {
        const std::size_t from = places.at(link->from), to = places.at(link->to);
        const Pose wanted = graph.nodes[from].pose * link->pose * graph.nodes[to].pose.inverse();
        const bool forward = roots[from] < roots[to];
        const std::size_t stays = std::min(roots[from], roots[to]), goes = std::max(roots[from], roots[to]);
        for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
            if (roots[i] != goes) continue;
            graph.nodes[i].pose = (forward ? wanted : wanted.inverse()) * graph.nodes[i].pose;
            roots[i] = stays;
        }
    }
}

}  // namespace leitstand
