#include "robots/simulation/stock/stock_navigation.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include "robots/simulation/stock/stock_localisation.h"

namespace leitstand::simulation {
namespace {

constexpr std::chrono::milliseconds ProgressPeriod{100}, Patience{6'000};
constexpr double Arrived = 0.15, GotOn = 0.02;                 // [m]
constexpr double Speed = 0.26, TurnRate = 0.9, Facing = 0.35;  // [m/s], [rad/s], [rad]; Nav2's defaults

}  // namespace

Result<std::unique_ptr<StockNavigation>> StockNavigation::create(Node& node, const RobotDescription& robot) {
    const ServiceDescription* const action = robot.navigation();
    if (action == nullptr) return std::unique_ptr<StockNavigation>();
    auto navigation = std::make_unique<StockNavigation>();
    StockNavigation& its = *navigation;
    its.m_robot = robot;
    NavigationServer::Calls calls;
    calls.go = [&its](const NavigationGoal& goal) {
        if (goal.goal.header.frame != its.m_robot.odomFrame) return false;
        const std::lock_guard lock(its.m_mutex);
        if (its.m_goal) its.end(GoalTracker::Status::Aborted);  // the newer one goes before
        its.m_goal = Goal{goal, 1e9, {}};
        return true;
    };
    calls.cancel = [&its](const GoalId& goal) {
        const std::lock_guard lock(its.m_mutex);
        const bool known = its.m_goal && (goal == GoalId{} || goal == its.m_goal->asked.id);
        if (known) its.end(GoalTracker::Status::Canceled);
        return known || goal == GoalId{};
    };
    auto server = NavigationServer::create(node, action->name, std::move(calls));
    if (!server) return server.error();
    its.m_server = std::move(server).value();
    return navigation;
}

void StockNavigation::end(GoalTracker::Status status) {
    m_last = GoalTracker::Report{m_goal->asked.id, status};
    m_goal.reset();
    m_progressDue = {};
}

std::optional<TwistSample> StockNavigation::steer(Goal& goal, Time now) {
    const Pose goalInBase = m_odometry->baseInOdom.inverse() * goal.asked.goal.poseInFrame;
    const Eigen::Vector2d way = goalInBase.translation().head<2>();
    if (goal.gotOn == Time{}) goal.gotOn = now;
    if (way.norm() < goal.nearest - GotOn) {
        goal.nearest = way.norm();
        goal.gotOn = now;
    }
    if (way.norm() < Arrived) {
        end(GoalTracker::Status::Succeeded);
        return TwistSample{};
    }
    if (now - goal.gotOn > Patience) {
        end(GoalTracker::Status::Aborted);
        return TwistSample{};
    }
    const double turn = std::atan2(way.y(), way.x());
    TwistSample twist;
    twist.angular.z() = std::clamp(2.0 * turn, -TurnRate, TurnRate);
    if (std::abs(turn) < Facing) twist.linear.x() = std::min(Speed, way.norm());
    return twist;
}

std::optional<TwistSample> StockNavigation::step(Time now, const std::vector<HardwareSample>& sent) {
    for (const HardwareSample& one : sent) {
        if (const auto* odometry = one.sample.as<OdometrySample>()) m_odometry = *odometry;
    }
    const std::lock_guard lock(m_mutex);
    std::optional<TwistSample> twist;
    if (m_goal && m_odometry) twist = steer(*m_goal, now);
    if (now < m_progressDue) return twist;
    m_progressDue = now + ProgressPeriod;
    std::vector<GoalTracker::Report> reports;
    if (m_last) reports.push_back(*m_last);
    if (m_goal) {
        reports.push_back({m_goal->asked.id, GoalTracker::Status::Executing});
        m_server->progress({m_goal->asked.id, m_goal->nearest / Speed, 0, m_goal->nearest});
    }
    if (!reports.empty()) m_server->report(reports);
    return twist;
}

}  // namespace leitstand::simulation
