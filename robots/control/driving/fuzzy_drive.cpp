#include "robots/control/driving/fuzzy_drive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

#include "core/robot/robot_format.h"

namespace leitstand {
namespace {

constexpr double Pi = std::numbers::pi;
constexpr std::array<std::string_view, 9> KnownInputs = {
    "front", "front_left", "front_right", "left", "right", "rear", "goal", "goal_free", "open"};

/// Returns the distance of @p point from the outside of @p body; 0 within [m].
double distanceTo(const BodyBox& body, const Eigen::Vector2d& point) {
    const double x = std::max({0.0, point.x() - body.front, -body.back - point.x()});
    const double y = std::max({0.0, point.y() - body.left, -body.right - point.y()});
    return std::hypot(x, y);
}

/// Returns the distance of the nearest obstacle from the body in directions from @p from to @p to degrees.
double gap(const VirtualScanView& view, const BodyBox& body, double from, double to, double sight) {
    double nearest = sight;
    for (const VirtualObstacle& one : view.obstacles) {
        const double direction = inDegrees(std::atan2(one.where.y(), one.where.x()));
        const double turned = direction < from ? direction + 360.0 : direction;
        if (turned >= from && turned <= to) nearest = std::min(nearest, distanceTo(body, one.where));
    }
    return nearest;
}

/// Returns a motion when a corner of the body blocks a turn on the spot. First choice is the same turn while
/// it drives on or back, whichever is free for longer, as drivers do in narrow streets. Second choice, when
/// the goal is behind and it sees there: back out of a blind alley on the curve that is free for longest.
/// Last choice is to drive straight.
DriveVelocity turnInTheNarrow(const DriveVelocity& requested, double goal, const VirtualScanView& view,
                              const FuzzyDriveSettings& settings, double share) {
    const BodyBox body = settings.safety.body.grown(settings.safety.margin);
    const double slow = 0.35 * share * settings.speed;
    const double turn = std::copysign(0.4 * share * settings.turnRate, requested.turn);
    constexpr double Useful = 0.06;  // [m]
    constexpr double Lately = 4.0;   // [s]
    const auto longestOf = [&](std::initializer_list<DriveVelocity> motions) {
        DriveVelocity best;
        double longest = Useful;
        for (const DriveVelocity& one : motions) {
            const double free = view.freeTravel(one.forward, one.turn, body, 0.5);
            if (free <= longest) continue;
            longest = free;
            best = one;
        }
        return best;
    };
    DriveVelocity best = longestOf({{slow, 0.0, turn}, {-slow, 0.0, turn}});
    const bool seesBehind = view.oldest(degrees(165), degrees(-165)) < Lately;
    if (isZero(best) && std::abs(goal) > 0.5 * Pi && seesBehind)
        best = longestOf(
            {{-slow, 0.0, 0.0}, {-slow, 0.0, 0.5 * turn}, {-slow, 0.0, -0.5 * turn}, {-slow, 0.0, -turn}});
    if (isZero(best)) best = longestOf({{slow, 0.0, 0.0}, {-slow, 0.0, 0.0}});
    return best;
}

}  // namespace

FuzzyDrive::FuzzyDrive(FuzzySystem system, const FuzzyDriveSettings& settings)
    : m_system(std::move(system)), m_settings(settings) {}

Result<FuzzyDrive> FuzzyDrive::create(FuzzySystem system, const FuzzyDriveSettings& settings) {
    for (const auto& [name, variable] : system.inputs) {
        if (std::find(KnownInputs.begin(), KnownInputs.end(), name) == KnownInputs.end())
            return Error{fmt::format("inputs.{}: expected one of {}", name, fmt::join(KnownInputs, ", "))};
    }
    for (const auto& [name, variable] : system.outputs) {
        if (name != "speed" && name != "turn")
            return Error{fmt::format("outputs.{}: expected speed or turn", name)};
    }
    if (system.outputs.size() != 2) return Error{"outputs: expected speed and turn"};
    return FuzzyDrive(std::move(system), settings);
}

FuzzyValues FuzzyDrive::inputsOf(const VirtualScanView& view, std::optional<double> goal) const {
    const BodyBox& body = m_settings.safety.body;
    const double width = body.left + body.right + 2.0 * m_settings.safety.margin;
    const double sight = m_settings.sight;
    const auto freeTowards = [&](double direction) {
        return std::max(0.0, view.freeLength(direction, width, sight + body.front) - body.front);
    };
    double open = 0.0, widest = -1.0;
    for (int step = -17; step <= 18; ++step) {
        const double direction = degrees(10.0 * step);
        const double away =
            goal ? std::abs(std::remainder(direction - *goal, 2.0 * Pi)) : std::abs(direction);
        const double score = freeTowards(direction) - 0.3 * away;
        if (score <= widest) continue;
        widest = score;
        open = direction;
    }
    return {{"front", freeTowards(0.0)},
            {"front_left", gap(view, body, 15.0, 65.0, sight)},
            {"left", gap(view, body, 65.0, 115.0, sight)},
            {"front_right", gap(view, body, -65.0, -15.0, sight)},
            {"right", gap(view, body, -115.0, -65.0, sight)},
            {"rear", gap(view, body, 150.0, 210.0, sight)},
            {"goal", inDegrees(std::remainder(goal.value_or(0.0), 2.0 * Pi))},
            {"goal_free", freeTowards(goal.value_or(0.0))},
            {"open", inDegrees(open)}};
}

FuzzyDriveStep FuzzyDrive::step(const VirtualScanView& view, std::optional<double> goal, double share) const {
    FuzzyDriveStep step;
    step.inputs = inputsOf(view, goal);
    step.result = m_system.infer(step.inputs);
    const int strongest = step.result.strongest();
    if (strongest < 0) {
        step.reason = robot_format::NoRule;
        return step;
    }
    step.reason = m_system.rules[static_cast<std::size_t>(strongest)].text;
    const double bounded = std::clamp(share, 0.0, 1.0);
    const DriveVelocity requested{
        bounded * m_settings.speed * std::clamp(step.result.outputs["speed"], -1.0, 1.0), 0.0,
        bounded * m_settings.turnRate * std::clamp(step.result.outputs["turn"], -1.0, 1.0)};
    SafeVelocity safe = safeVelocity(requested, view, m_settings.safety);
    if (safe.share < 0.15 && std::abs(requested.forward) > 0.01) {
        // It cannot go on: it turns on the spot to where the rules, or else the free space, lead.
        const double towards = std::abs(requested.turn) > 0.05 ? requested.turn : step.inputs["open"];
        const DriveVelocity turn{0.0, 0.0, std::copysign(0.5 * bounded * m_settings.turnRate, towards)};
        const SafeVelocity turning = safeVelocity(turn, view, m_settings.safety);
        if (turning.share > safe.share) safe = turning;
    }
    if (safe.share < 0.15 && std::abs(requested.turn) > 0.05) {
        const DriveVelocity bent = turnInTheNarrow(requested, std::remainder(goal.value_or(0.0), 2.0 * Pi),
                                                   view, m_settings, bounded);
        const SafeVelocity moving = safeVelocity(bent, view, m_settings.safety);
        if (!isZero(bent) && moving.share > safe.share) safe = moving;
    }
    step.velocity = safe.velocity;
    if (!safe.reason.empty()) step.reason += "; " + safe.reason;
    return step;
}

}  // namespace leitstand
