#include "core/mapping/graph/graph_solver.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>

#include "core/mapping/graph/block_cholesky.h"
#include "core/mapping/graph/link_error.h"

namespace leitstand {
namespace {

constexpr std::size_t Held = static_cast<std::size_t>(-1);

/// A link between nodes, by their places in the graph.
struct Edge {
    std::size_t link = 0;
    std::size_t from = 0, to = 0;  ///< nodes
    std::size_t pair = Held;       ///< of the matrix; Held: one of the nodes does not move
    bool turned = false;           ///< the pair's row is `from`
};

class Problem {
public:
    explicit Problem(PoseGraph& graph);

    [[nodiscard]] bool empty() const { return m_moving.empty(); }
    [[nodiscard]] double cost() const { return cost(m_poses); }
    /// Runs Levenberg-Marquardt once, with the links' current weights.
    void minimise(const GraphSettings& settings, int iterations, const Progress& progress,
                  GraphResult& result);
    /// Returns e^T Omega e of @p edge.
    [[nodiscard]] double disagreement(const Edge& edge) const;
    void finish();

    std::vector<Edge> edges;
    std::vector<double> weights;  ///< of the graph's links

private:
    [[nodiscard]] double cost(const std::vector<Pose>& poses) const;
    void holdOneOfEachPart(std::vector<bool>& held) const;
    /// Computes matrix and gradient at the poses. Returns the cost.
    double linearise();
    [[nodiscard]] std::vector<Pose> moved(const std::vector<LinkVector>& step) const;

    PoseGraph& m_graph;
    std::vector<Pose> m_poses;
    std::vector<std::size_t> m_moving;    ///< nodes
    std::vector<std::size_t> m_variable;  ///< of each node; Held: none
    std::optional<BlockCholesky> m_matrix;
    std::vector<LinkVector> m_gradient;
};

Problem::Problem(PoseGraph& graph) : weights(graph.links.size(), 1.0), m_graph(graph) {
    std::unordered_map<std::uint64_t, std::size_t> places;
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        places.emplace(graph.nodes[i].id, i);
        m_poses.push_back(graph.nodes[i].pose);
    }
    for (std::size_t i = 0; i < graph.links.size(); ++i) {
        const Link& link = graph.links[i];
        const auto from = places.find(link.from), to = places.find(link.to);
        if (!link.active || from == places.end() || to == places.end() || from == to) continue;
        edges.push_back({i, from->second, to->second});
    }
    std::vector<bool> held(graph.nodes.size());
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) held[i] = graph.nodes[i].fixed;
    holdOneOfEachPart(held);
    m_variable.assign(graph.nodes.size(), Held);
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        if (held[i]) continue;
        m_variable[i] = m_moving.size();
        m_moving.push_back(i);
    }
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    const auto pairOf = [this](const Edge& edge) {
        return std::make_pair(std::max(m_variable[edge.from], m_variable[edge.to]),
                              std::min(m_variable[edge.from], m_variable[edge.to]));
    };
    for (const Edge& edge : edges) {
        if (m_variable[edge.from] != Held && m_variable[edge.to] != Held) pairs.push_back(pairOf(edge));
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    for (Edge& edge : edges) {
        if (m_variable[edge.from] == Held || m_variable[edge.to] == Held) continue;
        edge.pair = static_cast<std::size_t>(std::lower_bound(pairs.begin(), pairs.end(), pairOf(edge)) -
                                             pairs.begin());
        edge.turned = m_variable[edge.from] > m_variable[edge.to];
    }
    m_matrix.emplace(m_moving.size(), pairs);
    m_gradient.resize(m_moving.size());
}

void Problem::holdOneOfEachPart(std::vector<bool>& held) const {
    std::vector<std::size_t> part(held.size());
    std::iota(part.begin(), part.end(), std::size_t{0});
    const auto rootOf = [&part](std::size_t node) {
        while (part[node] != node) node = part[node] = part[part[node]];
        return node;
    };
    for (const Edge& edge : edges) {
        const auto [low, high] = std::minmax({rootOf(edge.from), rootOf(edge.to)});
        part[high] = low;
    }
    std::vector<bool> anchored(held.size());
    for (std::size_t i = 0; i < held.size(); ++i) {
        if (held[i]) anchored[rootOf(i)] = true;
    }
    for (std::size_t i = 0; i < held.size(); ++i) {
        if (anchored[rootOf(i)]) continue;
        held[i] = anchored[rootOf(i)] = true;
    }
}

double Problem::cost(const std::vector<Pose>& poses) const {
    double sum = 0.0;
    for (const Edge& edge : edges) {
        const Link& link = m_graph.links[edge.link];
        const LinkVector error = linkError(poses[edge.from], poses[edge.to], link.pose);
        sum += 0.5 * weights[edge.link] * error.dot(link.information * error);
    }
    return sum;
}

double Problem::disagreement(const Edge& edge) const {
    const Link& link = m_graph.links[edge.link];
    const LinkVector error = linkError(m_poses[edge.from], m_poses[edge.to], link.pose);
    return error.dot(link.information * error);
}

double Problem::linearise() {
    m_matrix->clear();
    std::fill(m_gradient.begin(), m_gradient.end(), LinkVector::Zero());
    double sum = 0.0;
    for (const Edge& edge : edges) {
        const Link& link = m_graph.links[edge.link];
        const LinearLink linear = linearLink(m_poses[edge.from], m_poses[edge.to], link.pose);
        const Information information = weights[edge.link] * link.information;
        const LinkVector force = information * linear.error;
        sum += 0.5 * linear.error.dot(force);
        const Information fromForce = linear.byFrom.transpose() * information;
        const Information toForce = linear.byTo.transpose() * information;
        const std::size_t from = m_variable[edge.from], to = m_variable[edge.to];
        if (from != Held) {
            m_matrix->addDiagonal(from, fromForce * linear.byFrom);
            m_gradient[from].noalias() += linear.byFrom.transpose() * force;
        }
        if (to != Held) {
            m_matrix->addDiagonal(to, toForce * linear.byTo);
            m_gradient[to].noalias() += linear.byTo.transpose() * force;
        }
        if (edge.pair != Held)
            m_matrix->addPair(edge.pair, edge.turned ? Information(fromForce * linear.byTo)
                                                     : Information(toForce * linear.byFrom));
    }
    return sum;
}

std::vector<Pose> Problem::moved(const std::vector<LinkVector>& step) const {
    std::vector<Pose> poses = m_poses;
    for (std::size_t i = 0; i < m_moving.size(); ++i)
        poses[m_moving[i]] = movedBy(poses[m_moving[i]], step[i]);
    return poses;
}

void Problem::minimise(const GraphSettings& settings, int iterations, const Progress& progress,
                       GraphResult& result) {
    double damping = settings.initialDamping, growth = 2.0;
    double now = linearise();
    result.converged = false;
    for (int i = 0; i < iterations; ++i) {
        if (progress.cancelled()) return;
        ++result.iterations;
        std::vector<LinkVector> step;
        double expected = 0.0, then = 0.0;
        std::vector<Pose> poses;
        if (m_matrix->factor(damping)) {
            step = m_matrix->solve(m_gradient);
            for (std::size_t v = 0; v < step.size(); ++v) {
                step[v] = -step[v];
                expected += 0.5 * (damping * step[v].cwiseAbs2().dot(m_matrix->diagonal(v)) -
                                   step[v].dot(m_gradient[v]));
            }
            poses = moved(step);
            then = cost(poses);
        }
        if (step.empty() || !std::isfinite(then) || then > now) {
            if (!step.empty() && std::isfinite(then) && expected <= settings.costChange * now) {
                result.converged = true;
                return;
            }
            damping *= growth;
            growth *= 2.0;
            if (damping > 1e12) return;
            continue;
        }
        const double gain = expected > 0.0 ? (now - then) / expected : 1.0;
        damping = std::max(1e-12, damping * std::max(1.0 / 3.0, 1.0 - std::pow(2.0 * gain - 1.0, 3.0)));
        growth = 2.0;
        m_poses = std::move(poses);
        const bool settled = now - then <= settings.costChange * now;
        if (settled) {
            result.converged = true;
            return;
        }
        if (i + 1 < iterations) now = linearise();
    }
}

void Problem::finish() {
    for (const std::size_t node : m_moving) m_graph.nodes[node].pose = m_poses[node];
}

/// Sets the weights of the loop links for the surrogate of sharpness @p mu (Yang et al. 2020, equation 14).
/// Returns whether all are 0 or 1.
bool weigh(Problem& problem, const PoseGraph& graph, double mu, double most) {
    bool settled = true;
    for (const Edge& edge : problem.edges) {
        if (graph.links[edge.link].kind != LinkKind::Loop) continue;
        const double error = problem.disagreement(edge);
        double& weight = problem.weights[edge.link];
        if (error >= (mu + 1.0) / mu * most) {
            weight = 0.0;
        } else if (error <= mu / (mu + 1.0) * most) {
            weight = 1.0;
        } else {
            weight = std::clamp(std::sqrt(most * mu * (mu + 1.0) / error) - mu, 0.0, 1.0);
            settled = false;
        }
    }
    return settled;
}

}  // namespace

double costOf(const PoseGraph& graph) {
    std::unordered_map<std::uint64_t, const GraphNode*> nodes;
    for (const GraphNode& node : graph.nodes) nodes.emplace(node.id, &node);
    double sum = 0.0;
    for (const Link& link : graph.links) {
        const auto from = nodes.find(link.from), to = nodes.find(link.to);
        if (!link.active || from == nodes.end() || to == nodes.end() || from == to) continue;
        const LinkVector error = linkError(from->second->pose, to->second->pose, link.pose);
        sum += 0.5 * error.dot(link.information * error);
    }
    return sum;
}

GraphResult solve(PoseGraph& graph, const GraphSettings& settings, const Progress& progress) {
    GraphResult result;
    result.costBefore = costOf(graph);
    Problem problem(graph);
    if (problem.empty() || problem.edges.empty()) {
        result.cost = result.costBefore;
        result.converged = true;
        result.weights = problem.weights;
        return result;
    }
    if (settings.robust) {
        constexpr double Sharper = 1.4;              // as in the paper ...
        constexpr double Blunt = 1e-3, Twice = 2.0;  // ... but while weights hardly differ
        constexpr int Rounds = 60, AtFirst = 10, Few = 3;
        const double most = settings.mostDisagreement;
        problem.minimise(settings, AtFirst, progress, result);
        double largest = 0.0;
        for (const Edge& edge : problem.edges) {
            if (graph.links[edge.link].kind == LinkKind::Loop)
                largest = std::max(largest, problem.disagreement(edge));
        }
        double mu = most / std::max(2.0 * largest - most, 1e-9);
        for (int round = 0; round < Rounds && 2.0 * largest > most;
             ++round, mu *= mu < Blunt ? Twice : Sharper) {
            const bool settled = weigh(problem, graph, mu, most);
            problem.minimise(settings, settled ? settings.maxIterations : Few, progress, result);
            if (settled || progress.cancelled()) break;
        }
    } else {
        problem.minimise(settings, settings.maxIterations, progress, result);
    }
    problem.finish();
    result.weights = problem.weights;
    result.cost = problem.cost();
    return result;
}

}  // namespace leitstand
