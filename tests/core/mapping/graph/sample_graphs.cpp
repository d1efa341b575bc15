#include "tests/core/mapping/graph/sample_graphs.h"

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

namespace leitstand::test {
namespace {

class Noise {
public:
    Noise(const LinkNoise& noise, std::uint64_t seed) : m_noise(noise), m_random(seed) {}

    Link link(std::size_t from, std::size_t to, const std::vector<Pose>& poses, LinkKind kind) {
        Link link;
        link.id = ++m_links;
        link.from = from + 1;
        link.to = to + 1;
        link.kind = kind;
        link.pose = poses[from].inverse() * poses[to];
        const Eigen::Vector3d turn = m_noise.rotation * vector();
        link.pose.translation() += m_noise.translation * vector();
        link.pose.linear() =
            link.pose.linear() * Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()).toRotationMatrix();
        link.information.topLeftCorner<3, 3>() /= m_noise.translation * m_noise.translation;
        link.information.bottomRightCorner<3, 3>() /= m_noise.rotation * m_noise.rotation;
        return link;
    }
    Eigen::Vector3d vector() {
        std::normal_distribution<double> normal;
        return {normal(m_random), normal(m_random), normal(m_random)};
    }
    std::size_t below(std::size_t bound) {
        return std::uniform_int_distribution<std::size_t>(0, bound - 1)(m_random);
    }

private:
    LinkNoise m_noise;
    std::mt19937_64 m_random;
    std::uint64_t m_links = 0;
};

PoseGraph chained(const std::vector<Pose>& poses, Noise& noise) {
    PoseGraph graph;
    for (std::size_t i = 0; i + 1 < poses.size(); ++i)
        graph.links.push_back(noise.link(i, i + 1, poses, LinkKind::Odometry));
    for (std::size_t i = 0; i < poses.size(); ++i)
        graph.nodes.push_back(
            {i + 1, i == 0 ? poses[0] : graph.nodes[i - 1].pose * graph.links[i - 1].pose, false});
    return graph;
}

/// A random walk on the crossings of a grid 4 m apart, one node a metre; never straight back.
std::vector<Pose> floorWay(int nodes, int side, std::uint64_t seed) {
    constexpr int Step = 4;
    Noise random({}, seed);
    const std::vector<Eigen::Vector2i> ways = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    std::vector<Pose> poses;
    Eigen::Vector2i at(0, 0);
    std::size_t heading = 0;
    while (poses.size() < static_cast<std::size_t>(nodes)) {
        std::vector<std::size_t> open;
        for (std::size_t way = 0; way < ways.size(); ++way) {
            const Eigen::Vector2i then = at + ways[way];
            if (way != (heading + 2) % 4 && (then.array() >= 0).all() && (then.array() < side).all())
                open.push_back(way);
        }
        heading = open[random.below(open.size())];
        for (int metre = 0; metre < Step && poses.size() < static_cast<std::size_t>(nodes); ++metre) {
            Pose pose = Pose::Identity();
            pose.translation().head<2>() = (Step * at + metre * ways[heading]).cast<double>();
            pose.linear() =
                Eigen::AngleAxisd(double(heading) * 0.5 * std::numbers::pi, Eigen::Vector3d::UnitZ())
                    .toRotationMatrix();
            poses.push_back(pose);
        }
        at += ways[heading];
    }
    return poses;
}

}  // namespace

PoseGraph sphereGraph(int nodes, int rings, const LinkNoise& noise, std::uint64_t seed) {
    constexpr double Radius = 10.0;
    const int each = nodes / rings;
    std::vector<Pose> poses;
    for (int i = 0; i < nodes; ++i) {
        const double along = 2.0 * std::numbers::pi * i / each;
        const double up = std::numbers::pi * ((i + 0.5) / nodes - 0.5);
        const Eigen::Vector3d out(std::cos(up) * std::cos(along), std::cos(up) * std::sin(along),
                                  std::sin(up));
        const Eigen::Vector3d ahead(-std::sin(along), std::cos(along), 0.0);
        Pose pose = Pose::Identity();
        pose.linear() << ahead, out.cross(ahead), out;
        pose.translation() = Radius * out;
        poses.push_back(pose);
    }
    Noise random(noise, seed);
    PoseGraph graph = chained(poses, random);
    for (int i = 0; i + each < nodes; ++i) {
        graph.links.push_back(random.link(static_cast<std::size_t>(i), static_cast<std::size_t>(i + each),
                                          poses, LinkKind::Match));
    }
    return graph;
}

PoseGraph floorGraph(int nodes, int side, int wrong, const LinkNoise& noise, std::uint64_t seed) {
    const std::vector<Pose> poses = floorWay(nodes, side, seed);
    Noise random(noise, seed + 1);
    PoseGraph graph = chained(poses, random);
    std::map<std::pair<int, int>, std::size_t> seen;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const std::pair<int, int> place(static_cast<int>(std::lround(poses[i].translation().x())),
                                        static_cast<int>(std::lround(poses[i].translation().y())));
        const auto [earlier, first] = seen.emplace(place, i);
        if (!first && i > earlier->second + 10)
            graph.links.push_back(random.link(earlier->second, i, poses, LinkKind::Loop));
    }
    for (int i = 0; i < wrong; ++i) {
        const std::size_t from = random.below(poses.size()), to = random.below(poses.size());
        if (from == to) continue;
        Link link = random.link(from, to, poses, LinkKind::Loop);
        link.pose = Pose::Identity();  // "the same place"
        graph.links.push_back(link);
    }
    return graph;
}

PoseGraph trueFloorGraph(int nodes, int side, std::uint64_t seed) {
    PoseGraph graph;
    for (const Pose& pose : floorWay(nodes, side, seed))
        graph.nodes.push_back({graph.nodes.size() + 1, pose, false});
    return graph;
}

}  // namespace leitstand::test
