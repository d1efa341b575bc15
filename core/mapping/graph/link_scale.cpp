#include "core/mapping/graph/link_scale.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace leitstand {
namespace {

/// Where odometry has less of a say than that share of what matches have, surfaces hold the scan.
constexpr double Held = 0.05;
constexpr double RunError = 0.015;  ///< of the length of a run, whatever the length [m]
constexpr double Usual = 0.03;      ///< deviation of a scale of which nothing is known
constexpr double Most = 0.15;       ///< more than that is no scale

/// Information on the translation of `to` along @p direction, in the frame of `to`.
double along(const Link& link, const Eigen::Vector3d& direction) {
    return direction.dot(link.information.topLeftCorner<3, 3>() * direction);
}

/// Ways of one chain of odometry links.
struct Chain {
    double told = 0.0, matched = 0.0;  ///< of the run that goes on [m]
    double products = 0.0, squares = 0.0;
    std::vector<std::size_t> links;

    void end() {
        products += told * matched;
        squares += told * told;
        told = matched = 0.0;
    }
    /// The likeliest scale: near 1 as long as runs are short.
    [[nodiscard]] double scale() const {
        const double usual = RunError * RunError / (Usual * Usual);
        return std::clamp((products + usual) / (squares + usual), 1.0 - Most, 1.0 + Most);
    }
};

}  // namespace

void scaleOdometry(PoseGraph& graph) {
    std::unordered_map<std::uint64_t, std::size_t> places, chainOf;
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) places.emplace(graph.nodes[i].id, i);
    std::unordered_map<std::uint64_t, Information> held;  // by the scan that was matched
    for (const Link& link : graph.links) {
        if (!link.active || link.kind != LinkKind::Match) continue;
        const auto [known, added] = held.try_emplace(link.to, link.information);
        if (!added) known->second += link.information;
    }
    std::vector<Chain> chains;
    for (std::size_t i = 0; i < graph.links.size(); ++i) {
        const Link& link = graph.links[i];
        const auto from = places.find(link.from), to = places.find(link.to);
        if (link.kind != LinkKind::Odometry || from == places.end() || to == places.end()) continue;
        const auto before = chainOf.find(link.from);
        if (before == chainOf.end()) chains.emplace_back();
        const std::size_t at = before == chainOf.end() ? chains.size() - 1 : before->second;
        chainOf[link.from] = chainOf[link.to] = at;
        Chain& chain = chains[at];
        chain.links.push_back(i);
        const Eigen::Vector3d way = link.pose.translation();
        const double told = way.norm();
        if (told < 1e-3) continue;
        const Eigen::Vector3d direction = link.pose.linear().transpose() * way / told;
        const auto matches = held.find(link.to);
        const bool sure =
            matches != held.end() &&
            along(link, direction) < Held * direction.dot(matches->second.topLeftCorner<3, 3>() * direction);
        if (!sure) {
            chain.end();
            continue;
        }
        const Pose moved = graph.nodes[from->second].pose.inverse() * graph.nodes[to->second].pose;
        chain.told += told;
        chain.matched += moved.translation().dot(way) / told;
    }
    for (Chain& chain : chains) {
        chain.end();
        const double scale = chain.scale();
        for (const std::size_t i : chain.links) graph.links[i].pose.translation() *= scale;
    }
}

}  // namespace leitstand
