#include "core/mission/report/ways.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <unordered_map>
#include <utility>

namespace leitstand {
namespace {

constexpr double Apart = 0.10;    ///< trails are thinned to this [m]
constexpr double Crossing = 0.3;  ///< trails that come so near meet [m]
constexpr double Storey = 0.3;    ///< ... unless one is so far above the other [m]
constexpr double Far = std::numeric_limits<double>::infinity();

std::int64_t keyOf(const Eigen::Vector3d& point, int dx = 0, int dy = 0) {
    const auto x = static_cast<std::int64_t>(std::floor(point.x() / Crossing)) + dx,
               y = static_cast<std::int64_t>(std::floor(point.y() / Crossing)) + dy;
    return x * 0x100000 + y;
}

}  // namespace

struct WayFinder::Graph {
    struct Node {
        Eigen::Vector3d point;
        double way = Far;            ///< from a start [m]
        std::ptrdiff_t before = -1;  ///< node; -1: a start
        std::ptrdiff_t trail = -1;   ///< node before it on the trail
        std::size_t robot = 0;
    };
    std::vector<Node> nodes;
    std::vector<std::string> robots;
    std::unordered_multimap<std::int64_t, std::size_t> places;

    template <class Take>
    void forNeighbours(std::size_t of, Take take) const {
        const Node& node = nodes[of];
        if (node.trail >= 0) take(static_cast<std::size_t>(node.trail));
        if (of + 1 < nodes.size() && nodes[of + 1].trail == static_cast<std::ptrdiff_t>(of)) take(of + 1);
        for (int dx = -1; dx <= 1; ++dx) {
            for (int dy = -1; dy <= 1; ++dy) {
                const auto [first, last] = places.equal_range(keyOf(node.point, dx, dy));
                for (auto near = first; near != last; ++near) {
                    const Eigen::Vector3d away = nodes[near->second].point - node.point;
                    if (away.head<2>().norm() <= Crossing && std::abs(away.z()) <= Storey) take(near->second);
                }
            }
        }
    }
    void search() {
        using Entry = std::pair<double, std::size_t>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (nodes[i].trail < 0) open.emplace(nodes[i].way = 0.0, i);
        }
        while (!open.empty()) {
            const auto [way, node] = open.top();
            open.pop();
            if (way > nodes[node].way) continue;
            forNeighbours(node, [&, way = way, node = node](std::size_t next) {
                const double longer = way + (nodes[next].point - nodes[node].point).norm();
                if (longer >= nodes[next].way - 1e-12) return;
                nodes[next].way = longer;
                nodes[next].before = static_cast<std::ptrdiff_t>(node);
                nodes[next].robot = nodes[node].robot;
                open.emplace(longer, next);
            });
        }
    }
};

WayFinder::WayFinder(std::span<const RobotPath> paths) : m_graph(std::make_unique<Graph>()) {
    for (const RobotPath& path : paths) {
        std::ptrdiff_t before = -1;
        for (const PathPose& pose : path.poses) {
            const Eigen::Vector3d point = pose.baseInMap.translation();
            if (!point.allFinite() || point.head<2>().cwiseAbs().maxCoeff() > 1e5) continue;
            auto& nodes = m_graph->nodes;
            if (before >= 0 && (nodes[static_cast<std::size_t>(before)].point - point).norm() < Apart)
                continue;
            nodes.push_back({.point = point, .trail = before, .robot = m_graph->robots.size()});
            before = static_cast<std::ptrdiff_t>(nodes.size()) - 1;
        }
        m_graph->robots.push_back(path.robot);
    }
    for (std::size_t i = 0; i < m_graph->nodes.size(); ++i)
        m_graph->places.emplace(keyOf(m_graph->nodes[i].point), i);
    m_graph->search();
}

WayFinder::~WayFinder() = default;
WayFinder::WayFinder(WayFinder&&) noexcept = default;
WayFinder& WayFinder::operator=(WayFinder&&) noexcept = default;

Way WayFinder::to(const Eigen::Vector3d& place, double reach) const {
    const auto& nodes = m_graph->nodes;
    const auto away = [&](const Graph::Node& node) { return (node.point - place).head<2>().norm(); };
    double nearest = Far;
    for (const auto& node : nodes) nearest = std::min(nearest, away(node));
    if (!(nearest <= reach)) return {};
    // Of the points that are about as near, the one with the shortest way.
    const Graph::Node* goal = nullptr;
    for (const auto& node : nodes) {
        if (away(node) > nearest + 0.15) continue;
        if (goal == nullptr || node.way + away(node) < goal->way + away(*goal)) goal = &node;
    }
    Way way;
    way.lastPiece = away(*goal);
    way.length = goal->way + way.lastPiece;
    way.robot = m_graph->robots[goal->robot];
    way.points.push_back(place);
    for (const Graph::Node* node = goal;; node = &nodes[static_cast<std::size_t>(node->before)]) {
        way.points.push_back(node->point);
        if (node->before < 0) break;
    }
    std::reverse(way.points.begin(), way.points.end());
    return way;
}

}  // namespace leitstand
