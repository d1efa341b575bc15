#include "core/mapping/graph/odometry_errors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <Eigen/LU>

namespace leitstand {
namespace {

/// Surfaces hold a scan where odometry has less than this share of the information of matches.
constexpr double Held = 0.05;
constexpr double LeastWay = 1e-3;  ///< shorter links have no direction [m]

constexpr double WayError = 0.015;    ///< of the length of a run, however long [m]
constexpr double UsualScale = 0.03;   ///< prior deviation of the scale of distances and turns
constexpr double MostScale = 0.15;    ///< largest correction of a scale
constexpr double UsualDrift = 0.005;  ///< prior deviation of the heading's drift [rad/m] ...
constexpr double MostDrift = 0.05;    ///< ... and its largest correction [rad/m]

/// Headings are compared over this distance or turn, since the error of matches does not grow with it.
constexpr double ComparedWay = 3.0;               ///< [m]
constexpr double ComparedTurn = 1.0;              ///< [rad]
constexpr double TurnError = degrees(0.3);        ///< of a match's heading, from end to end [rad] ...
constexpr double TurnErrorOfTurn = 0.01;          ///< ... and random, of odometry's [rad/rad] ...
constexpr double TurnErrorOfWay = degrees(0.15);  ///< ... [rad/m]

/// A step that differs more from matches is no usual error of odometry: wheels slipped.
constexpr double SlippedWay = 0.1, SlippedOfWay = 0.3;            ///< [m], [m/m]
constexpr double SlippedTurn = degrees(5), SlippedOfTurn = 0.25;  ///< [rad], [rad/rad]

constexpr double MatchVariance = 2.0 * 0.007 * 0.007;  ///< of a distance between two matches [m^2]
constexpr double UsualRuns = 10.0;                     ///< weight of the usual variance, in runs
constexpr double MostLess = 0.25, MostMore = 4.0;      ///< weights change by no more than these factors

/// Returns the information on the translation of `to` along @p direction, in the frame of `to`.
double along(const Information& information, const Eigen::Vector3d& direction) {
    return direction.dot(information.topLeftCorner<3, 3>() * direction);
}
/// Returns the information on its rotation about @p axis.
double about(const Information& information, const Eigen::Vector3d& axis) {
    return axis.dot(information.bottomRightCorner<3, 3>() * axis);
}

/// Returns the turn of @p rotation about @p up [rad].
double turnAbout(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& up) {
    const Eigen::AngleAxisd turn(rotation);
    return turn.angle() * turn.axis().dot(up);
}

/// Estimates the scale of odometry's distances.
class WayScale {
public:
    void add(double measured, double matched) {
        m_measured += measured;
        m_matched += matched;
    }
    void endRun() {
        m_products += m_measured * m_matched;
        m_squares += m_measured * m_measured;
        m_measured = m_matched = 0.0;
    }
    /// Returns the likeliest factor: near 1 as long as runs are short.
    [[nodiscard]] double factor() const {
        const double usual = WayError * WayError / (UsualScale * UsualScale);
        return std::clamp((m_products + usual) / (m_squares + usual), 1.0 - MostScale, 1.0 + MostScale);
    }

private:
    double m_measured = 0.0, m_matched = 0.0;  ///< of the current run [m]
    double m_products = 0.0, m_squares = 0.0;
};

/// Estimates the errors of the heading: a share of turns, and a drift with the distance.
class HeadingErrors {
public:
    void add(double way, double measured, double matched) {
        m_way += way;
        m_measured += measured;
        m_matched += matched;
        if (std::abs(m_way) >= ComparedWay || std::abs(m_measured) >= ComparedTurn) endRun();
    }
    void endRun() {
        const double chance = TurnErrorOfTurn * m_measured, onTheWay = TurnErrorOfWay * m_way;
        const double weight = 1.0 / (TurnError * TurnError + chance * chance + onTheWay * onTheWay);
        const Eigen::Vector2d row(m_measured, m_way);
        m_normal += weight * row * row.transpose();
        m_right += weight * (m_matched - m_measured) * row;
        m_way = m_measured = m_matched = 0.0;
    }
    /// Returns the share of a turn that odometry is short of, and its drift with the distance [rad/m].
    [[nodiscard]] Eigen::Vector2d shares() const {
        const Eigen::Vector2d usual(1.0 / (UsualScale * UsualScale), 1.0 / (UsualDrift * UsualDrift));
        const Eigen::Matrix2d normal = m_normal + Eigen::Matrix2d(usual.asDiagonal());
        const Eigen::Vector2d found = normal.inverse() * m_right, most(MostScale, MostDrift);
        return found.cwiseMin(most).cwiseMax(-most);
    }

private:
    double m_way = 0.0, m_measured = 0.0, m_matched = 0.0;  ///< of the current run [m, rad]
    Eigen::Matrix2d m_normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d m_right = Eigen::Vector2d::Zero();
};

/// Estimates the random error of distances.
class WayNoise {
public:
    void add(double measured, double matched) {
        m_way += measured;
        m_error += matched - measured;
        if (m_way >= ComparedWay) endRun();
    }
    void endRun() {
        if (m_way >= 0.5 * ComparedWay) {
            m_sum += std::max(0.0, m_error * m_error - MatchVariance) / m_way;
            m_runs += 1.0;
        }
        m_way = m_error = 0.0;
    }
    /// Returns the variance [m^2/m]; @p usual: the one that is expected before any comparison.
    [[nodiscard]] double variance(double usual) const {
        return (UsualRuns * usual + m_sum) / (UsualRuns + m_runs);
    }

private:
    double m_way = 0.0, m_error = 0.0;  ///< of the current run [m]
    double m_sum = 0.0, m_runs = 0.0;
};

/// A link of odometry, and the same step by matches.
struct OdometryStep {
    std::size_t link = 0;
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();        ///< in the frame of `from`
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< of the motion, in the same frame; zero: none
    double way = 0.0, turn = 0.0;                         ///< by odometry [m, rad]
    double ahead = 0.0;  ///< distance, negative where the scan looks back along it [m]
    double matchedWay = 0.0, matchedTurn = 0.0;  ///< along the direction, about up [m, rad]
    bool wayHeld = false, turnHeld = false;      ///< by surfaces
};

/// Returns the information of the matches of each scan with others.
std::unordered_map<std::uint64_t, Information> heldScans(const PoseGraph& graph) {
    std::unordered_map<std::uint64_t, Information> held;
    for (const Link& link : graph.links) {
        if (!link.active || link.kind != LinkKind::Match) continue;
        const auto [known, added] = held.try_emplace(link.to, link.information);
        if (!added) known->second += link.information;
    }
    return held;
}

/// Returns the step of @p link. @p held: information of the matches of `to`; null: one of the ends has none.
OdometryStep stepOf(const Link& link, const Pose& from, const Pose& to, const Information* held) {
    OdometryStep step;
    step.up = from.linear().transpose() * Eigen::Vector3d::UnitZ();
    const Pose moved = from.inverse() * to;
    const Eigen::Vector3d way = link.pose.translation();
    step.way = way.norm();
    step.turn = turnAbout(link.pose.linear(), step.up);
    step.matchedTurn = turnAbout(moved.linear(), step.up);
    const auto inTo = [&](const Eigen::Vector3d& axis) {
        return Eigen::Vector3d(link.pose.linear().transpose() * axis);
    };
    const double turnOff = std::abs(step.matchedTurn - step.turn);
    step.turnHeld = held != nullptr && turnOff <= SlippedTurn + SlippedOfTurn * std::abs(step.turn) &&
                    about(link.information, inTo(step.up)) < Held * about(*held, inTo(step.up));
    if (step.way < LeastWay) return step;
    step.direction = way / step.way;
    step.ahead = std::copysign(step.way, way.x());
    step.matchedWay = moved.translation().dot(step.direction);
    const Eigen::Vector3d ahead = inTo(step.direction);
    const bool slipped = std::abs(step.matchedWay - step.way) > SlippedWay + SlippedOfWay * step.way;
    step.wayHeld = held != nullptr && !slipped && along(link.information, ahead) < Held * along(*held, ahead);
    return step;
}

/// The steps of one chain of odometry links.
using Chain = std::vector<OdometryStep>;

std::vector<Chain> chainsOf(const PoseGraph& graph) {
    std::unordered_map<std::uint64_t, std::size_t> places, chainOf;
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) places.emplace(graph.nodes[i].id, i);
    const auto held = heldScans(graph);
    std::vector<Chain> chains;
    for (std::size_t i = 0; i < graph.links.size(); ++i) {
        const Link& link = graph.links[i];
        const auto from = places.find(link.from), to = places.find(link.to);
        if (link.kind != LinkKind::Odometry || from == places.end() || to == places.end()) continue;
        const auto before = chainOf.find(link.from);
        if (before == chainOf.end()) chains.emplace_back();
        const std::size_t at = before == chainOf.end() ? chains.size() - 1 : before->second;
        chainOf[link.from] = chainOf[link.to] = at;
        // The first scan of all has no matches and stays in place.
        const bool fromHeld = held.contains(link.from) || before == chainOf.end();
        const auto matches = fromHeld ? held.find(link.to) : held.end();
        chains[at].push_back(stepOf(link, graph.nodes[from->second].pose, graph.nodes[to->second].pose,
                                    matches != held.end() ? &matches->second : nullptr));
        chains[at].back().link = i;
    }
    return chains;
}

void correct(PoseGraph& graph, const Chain& chain) {
    WayScale scale;
    HeadingErrors heading;
    for (const OdometryStep& step : chain) {
        if (step.way >= LeastWay) step.wayHeld ? scale.add(step.way, step.matchedWay) : scale.endRun();
        step.turnHeld ? heading.add(step.ahead, step.turn, step.matchedTurn) : heading.endRun();
    }
    scale.endRun();
    heading.endRun();
    const double factor = scale.factor();
    const Eigen::Vector2d shares = heading.shares();
    WayNoise noise;
    for (const OdometryStep& step : chain) {
        Pose& pose = graph.links[step.link].pose;
        const double turn = shares.dot(Eigen::Vector2d(step.turn, step.ahead));
        pose.translation() = Eigen::AngleAxisd(0.5 * turn, step.up) * (factor * pose.translation());
        pose.linear() = Eigen::AngleAxisd(turn, step.up) * pose.linear();
        step.wayHeld ? noise.add(factor * step.way, step.matchedWay) : noise.endRun();
    }
    noise.endRun();
    for (const OdometryStep& step : chain) {
        if (step.wayHeld || step.way < LeastWay) continue;
        Link& link = graph.links[step.link];
        const double measured = along(link.information, link.pose.linear().transpose() * step.direction);
        if (measured <= 0.0) continue;
        const double usual = 1.0 / (measured * step.way);
        link.information *= std::clamp(usual / noise.variance(usual), MostLess, MostMore);
    }
}

}  // namespace

void correctOdometry(PoseGraph& graph) {
    for (const Chain& chain : chainsOf(graph)) correct(graph, chain);
}

}  // namespace leitstand
