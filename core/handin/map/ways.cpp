#include "core/handin/map/ways.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace leitstand {
namespace {

constexpr double Apart = 0.10;      ///< trails are thinned to this [m]
constexpr double Crossing = 0.3;    ///< trails this near to each other meet [m]
constexpr double SameStorey = 0.3;  ///< ... unless one is this far above the other [m]
constexpr double Far = std::numeric_limits<double>::infinity();

constexpr double Touching = 0.15;  ///< what is seen this near to a find is its own surface [m] ...
constexpr double Own = 0.4;        ///< ... and so is what continues from there, up to here [m]
constexpr double Beside = 0.05;    ///< what stands this near to a straight piece is in its way [m]
constexpr double Alike = 0.15;     ///< distances that differ by less count as equal [m]

/// Whether @p map shows nothing between @p place and @p from except the surface of what is at @p place.
bool isClear(const OccupancyGrid& map, const Eigen::Vector2d& place, const Eigen::Vector2d& from) {
    const double length = (from - place).norm(), step = map.cell / 2;
    if (length < step) return true;
    const Eigen::Vector2d along = (from - place) / length,
                          side = Beside * Eigen::Vector2d(-along.y(), along.x());
    const auto occupied = [&](const Eigen::Vector2d& at) {
        return map.at(at.x(), at.y()).state == OccupancyGrid::State::Occupied;
    };
    bool own = false;
    for (double away = 0.0; away <= length; away += step) {
        const Eigen::Vector2d at = place + away * along;
        const bool stands = occupied(at) || occupied(at + side) || occupied(at - side);
        own = stands && (own || away <= Touching);
        if (stands && (!own || away > Own)) return false;
    }
    return true;
}

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
        std::ptrdiff_t gap = -1;     ///< node before it, across a gap
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
                    if (away.head<2>().norm() <= Crossing && std::abs(away.z()) <= SameStorey)
                        take(near->second);
                }
            }
        }
    }
    void search() {
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (nodes[i].trail < 0 && nodes[i].gap < 0) reach(i, 0.0, -1);
        }
        // Nodes that no known way reaches are reached straight over the gap.
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (nodes[i].way < Far || nodes[i].gap < 0) continue;
            const Node& before = nodes[static_cast<std::size_t>(nodes[i].gap)];
            reach(i, before.way + (before.point - nodes[i].point).norm(), nodes[i].gap);
        }
    }

private:
    using Entry = std::pair<double, std::size_t>;

    /// Reaches @p node by @p way from @p before, and from there all nodes to which that is the shortest way.
    void reach(std::size_t node, double way, std::ptrdiff_t before) {
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
        nodes[node].way = way;
        nodes[node].before = before;
        if (before >= 0) nodes[node].robot = nodes[static_cast<std::size_t>(before)].robot;
        open.emplace(way, node);
        while (!open.empty()) {
            const auto [soFar, at] = open.top();
            open.pop();
            if (soFar > nodes[at].way) continue;
            forNeighbours(at, [&, soFar = soFar, at = at](std::size_t next) {
                const double longer = soFar + (nodes[next].point - nodes[at].point).norm();
                if (longer >= nodes[next].way - 1e-12) return;
                nodes[next].way = longer;
                nodes[next].before = static_cast<std::ptrdiff_t>(at);
                nodes[next].robot = nodes[at].robot;
                open.emplace(longer, next);
            });
        }
    }
};

WayFinder::WayFinder(std::span<const RobotPath> paths) : m_graph(std::make_unique<Graph>()) {
    for (const RobotPath& path : paths) {
        std::ptrdiff_t before = -1;
        bool gap = false;
        for (const PathPose& pose : path.poses) {
            gap = gap || pose.afterGap;
            const Eigen::Vector3d point = pose.baseInMap.translation();
            if (!point.allFinite() || point.head<2>().cwiseAbs().maxCoeff() > 1e5) continue;
            auto& nodes = m_graph->nodes;
            if (before >= 0 && (nodes[static_cast<std::size_t>(before)].point - point).norm() < Apart)
                continue;
            nodes.push_back({.point = point,
                             .trail = gap ? -1 : before,
                             .gap = gap ? before : -1,
                             .robot = m_graph->robots.size()});
            gap = false;
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

Way WayFinder::to(const Eigen::Vector3d& place, const OccupancyGrid& map, const FloorHeights& floor,
                  double reach) const {
    using Near = std::pair<double, const Graph::Node*>;
    std::vector<Near> near;  // nearest first
    for (const auto& node : m_graph->nodes) {
        const double away = (node.point - place).head<2>().norm();
        if (away <= reach) near.emplace_back(away, &node);
    }
    if (near.empty()) return {};
    std::sort(near.begin(), near.end(), [](const Near& a, const Near& b) {
        return std::tie(a.first, a.second->way) < std::tie(b.first, b.second->way);
    });
    // Of about equally near points, takes the one with the shortest way.
    const auto best = [&](auto serves) -> std::optional<Near> {
        std::optional<Near> goal;
        double most = Far;
        for (const Near& one : near) {
            if (one.first > most) break;
            if (!serves(*one.second)) continue;
            if (!goal) most = one.first + Alike;
            if (!goal || one.second->way + one.first < goal->second->way + goal->first) goal = one;
        }
        return goal;
    };
    std::optional<Near> goal;
    if (!map.empty()) {
        const double ground = floor.below(place);
        goal = best([&](const Graph::Node& node) {
            return std::abs(floor.below(node.point) - ground) <= SameStorey &&
                   isClear(map, place.head<2>(), node.point.head<2>());
        });
    }
    Way way;
    way.clear = goal.has_value();
    if (!goal) goal = best([](const Graph::Node&) { return true; });
    way.lastPiece = goal->first;
    way.length = goal->second->way + way.lastPiece;
    way.robot = m_graph->robots[goal->second->robot];
    way.points.push_back(place);
    for (const Graph::Node* node = goal->second;;
         node = &m_graph->nodes[static_cast<std::size_t>(node->before)]) {
        way.points.push_back(node->point);
        if (node->before < 0) break;
    }
    std::reverse(way.points.begin(), way.points.end());
    return way;
}

}  // namespace leitstand
