#include "core/mapping/graph/graph_start.h"

#include <cstddef>
#include <unordered_map>

namespace leitstand {
namespace {

/// Lower is surer.
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
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        const Link* const link = surest[i];
        if (link == nullptr || graph.nodes[i].fixed) continue;
        const std::size_t from = places.at(link->from), to = places.at(link->to);
        graph.nodes[i].pose =
            to == i ? graph.nodes[from].pose * link->pose : graph.nodes[to].pose * link->pose.inverse();
    }
}

}  // namespace leitstand
