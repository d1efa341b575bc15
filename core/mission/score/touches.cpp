#include "core/mission/score/touches.h"

#include <algorithm>
#include <limits>

#include "core/robot/robot_description.h"

namespace leitstand {
namespace {

constexpr double UnknownRadius = 0.2;  // of a robot with an unknown footprint [m]
constexpr double Step = 0.02;          // along edges [m]
constexpr double RoundCorners =
    0.5;  // share of a half from which the edge is the bumper's: it reaches round corners
constexpr double Beyond = 0.1;  // share of a half from which something is on that side, not beside it

/// The part of a robot's edge that a bumper covers, by its name.
struct Side {
    int ahead = 0, left = 0;  ///< 1: that side, -1: the other one, 0: both

    explicit Side(const std::string& bumper) {
        const auto names = [&](const char* word) { return bumper.find(word) != std::string::npos; };
        ahead = names("front") ? 1 : names("rear") || names("back") ? -1 : 0;
        left = names("left") ? 1 : names("right") ? -1 : 0;
    }
    /// Whether @p place is on that side. When the bumper names both directions, only ahead and behind count:
    /// a body that lies across is on either hand.
    [[nodiscard]] bool mayMeet(const Eigen::Vector2d& place) const {
        return ahead == 0 ? has(place, Beyond) : ahead * place.x() >= Beyond;
    }
    /// Whether @p place is on that side. @p place and @p least (from the middle) are shares of the
    /// footprint's halves.
    [[nodiscard]] bool has(const Eigen::Vector2d& place, double least) const {
        return (ahead == 0 || ahead * place.x() >= least) && (left == 0 || left * place.y() >= least);
    }
};

}  // namespace

Footprints footprintsOf(std::span<const RobotDescription> robots) {
    Footprints all;
    for (const RobotDescription& robot : robots) all[robot.name] = robot.footprint;
    return all;
}

bool touches(const Pose& baseInMap, const std::vector<Eigen::Vector2d>& footprint, const std::string& bumper,
             const Eigen::Vector3d& victimInMap) {
    const Eigen::Vector2d victim = (baseInMap.inverse() * victimInMap).head<2>();
    if (!victim.allFinite()) return false;
    if (footprint.size() < 3) return victim.norm() < UnknownRadius + HalfLying;
    Eigen::Vector2d low = footprint.front(), high = low;
    for (const Eigen::Vector2d& corner : footprint) {
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
    }
    const Eigen::Vector2d middle = (low + high) / 2, half = ((high - low) / 2).cwiseMax(1e-3);
    if (((victim - middle).cwiseAbs() - half).maxCoeff() > HalfLying) return false;
    const Side side(bumper);
    if (!side.mayMeet((victim - middle).cwiseQuotient(half))) return false;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < footprint.size(); ++i) {
        const Eigen::Vector2d &from = footprint[i], &to = footprint[(i + 1) % footprint.size()];
        const int steps = std::clamp(static_cast<int>((to - from).norm() / Step), 1, 500);
        for (int step = 0; step <= steps; ++step) {
            const Eigen::Vector2d edge = from + (to - from) * (static_cast<double>(step) / steps);
            if (side.has((edge - middle).cwiseQuotient(half), RoundCorners))
                nearest = std::min(nearest, (edge - victim).norm());
        }
    }
    return nearest < HalfLying;
}

}  // namespace leitstand
