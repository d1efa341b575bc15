#include "robots/simulation/world/robot.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "core/base/rotation/heading.h"

namespace leitstand::simulation {
namespace {

constexpr double Gravity = 9.81;      ///< [m/s2]
constexpr double SlipHolds = 0.5;     ///< [s]
constexpr double FeelAtLeast = 0.05;  ///< longest time between casts of feelers, also at a standstill [s]
constexpr double LongestBlindWay = 0.015;  ///< [m]

double farthest(const BodySpec& spec) {
    double reach = 0.0;
    for (const Eigen::Vector2d& corner : spec.outline) reach = std::max(reach, corner.norm());
    return reach;
}

}  // namespace

Robot::Robot(const BodySpec& spec, int body, std::uint64_t seed, const Pose& baseInArena)
    : m_spec(spec),
      m_body(body),
      m_draws(seed),
      m_suspension(m_spec),
      m_driveTrain(m_spec),
      m_feelers(m_spec) {
    m_state.baseInArena = baseInArena;
}

void Robot::setMotors(double left, double right) {
    m_left = std::isfinite(left) ? std::clamp(left, -1.0, 1.0) : 0.0;
    m_right = std::isfinite(right) ? std::clamp(right, -1.0, 1.0) : 0.0;
}

void Robot::settle(const Scene& scene) {
    Pose& pose = m_state.baseInArena;
    pose = poseOnPlane(pose.translation(), headingOf(pose), Eigen::Vector3d::UnitZ());
    m_footing = m_suspension.settle(scene, pose);
}

void Robot::moveTo(const Pose& baseInArena, Time now) {
    m_state.baseInArena = baseInArena;
    remember(now);
}

void Robot::drawSlip(double seconds) {
    m_slipFor -= seconds;
    if (m_slipFor > 0.0) return;
    m_slipFor += SlipHolds;
    const auto draw = [this] {
        const double sigmas = std::clamp(m_draws.next(), -3.0, 3.0);
        return m_spec.slip.mean + sigmas * m_spec.slip.deviation;
    };
    m_leftSlip = draw();
    m_rightSlip = draw();
}

double Robot::slipOf(double drawn, double speed) const {
    const Eigen::Matrix3d turn = m_state.baseInArena.linear();
    const double slope = turn(2, 0) / std::max(0.2, std::hypot(turn(0, 0), turn(1, 0)));
    const double uphill = std::max(0.0, speed > 0.0 ? slope : -slope);
    return std::clamp(drawn + m_spec.slip.onRamps * uphill, -0.5, 0.9);
}

void Robot::drive(double seconds) {
    Pose& pose = m_state.baseInArena;
    DriveInput input;
    input.leftVoltage = m_left;
    input.rightVoltage = m_right;
    input.brake = m_brake;
    if (m_footing.supported) input.gravity = -Gravity * pose.linear().row(2).head<2>().transpose();
    input.leftLoad = m_footing.leftLoad;
    input.rightLoad = m_footing.rightLoad;
    input.bellyLoad = m_footing.bellyLoad;
    input.leftSlip = slipOf(m_leftSlip, m_speeds.left);
    input.rightSlip = slipOf(m_rightSlip, m_speeds.right);
    m_driveTrain.step(m_speeds, input, m_pushes, seconds);
    const Eigen::Vector3d way(m_speeds.linear.x(), m_speeds.linear.y(), 0.0);
    pose.translation() += pose.linear() * way * seconds;
    const Eigen::Matrix3d turned =
        pose.linear() * Eigen::AngleAxisd(m_speeds.turn * seconds, Eigen::Vector3d::UnitZ());
    pose = poseOnPlane(pose.translation(), headingOf(turned), pose.linear().col(2));
}

void Robot::stand(const Scene& scene, double seconds) {
    const bool still = m_speeds.linear.isZero() && m_speeds.turn == 0.0;
    if (still && m_suspension.resting() && m_footing.supported) return;
    Pose& pose = m_state.baseInArena;
    m_footing = m_suspension.step(scene, pose, seconds);
    if (!m_footing.tips) return;
    // The robot falls to where it leans, about its lowest corner on that side.
    const Eigen::Vector3d up = pose.linear().col(2);
    Eigen::Vector2d leans = up.head<2>();
    leans = leans.norm() > 1e-6 ? Eigen::Vector2d(leans.normalized())
                                : Eigen::Vector2d(pose.linear().col(0).head<2>());
    Topple topple;
    topple.axis = Eigen::Vector3d(-leans.y(), leans.x(), 0.0);
    double farthestOut = -1e9;
    for (const Eigen::Vector3d& contact : m_spec.contacts) {
        const Eigen::Vector3d at = pose * contact;
        const double out = leans.dot(at.head<2>()) - 2.0 * at.z();
        if (out > farthestOut) {
            farthestOut = out;
            topple.pivot = at;
        }
    }
    m_topple = topple;
}

void Robot::topple(double seconds) {
    Pose& pose = m_state.baseInArena;
    const double tilt = std::acos(std::clamp(pose.linear()(2, 2), -1.0, 1.0));
    m_topple->speed += 1.2 * Gravity / 0.2 * std::sin(tilt) * seconds;
    constexpr double OnItsSide = 0.5 * 3.14159265358979323846;
    const double angle = std::min(m_topple->speed * seconds, OnItsSide - tilt);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, m_topple->axis).toRotationMatrix();
    pose.translation() = m_topple->pivot + turn * (pose.translation() - m_topple->pivot);
    pose.linear() = turn * pose.linear();
    if (tilt + angle < OnItsSide - 1e-6) return;
    // Lifts the robot so that its outline lies on the ground, not in it.
    double lowest = m_topple->pivot.z();
    for (const Eigen::Vector2d& corner : m_spec.outline) {
        for (const double height : {m_spec.bumpFrom, m_spec.bumpTo}) {
            lowest = std::min(lowest, (pose * Eigen::Vector3d(corner.x(), corner.y(), height)).z());
        }
    }
    pose.translation().z() += m_topple->pivot.z() - lowest;
    pose = orthonormalised(pose);
    m_state.tipped = true;
    m_topple.reset();
}

std::vector<Bump> Robot::lookForBumps(const Surroundings& around, double seconds) {
    m_feltAgo += seconds;
    m_freeWay -= (m_speeds.linear.norm() + std::abs(m_speeds.turn) * farthest(m_spec)) * seconds;
    const bool due = m_feltAgo >= FeelAtLeast || m_freeWay <= 0.0 || around.othersNear;
    if (!due) return {};
    m_feltAgo = 0.0;
    m_pushes.clear();
    std::vector<Bump> bumps;
    const auto& elements = around.scene.arena().elements;
    const auto touch = [&](const Obstacle& obstacle) {
        if (!m_bumpCounter.isNew(obstacle, around.now)) return;
        Bump bump;
        bump.at = around.now;
        bump.robot = m_body;
        bump.victim = obstacle.victim;
        bump.where = obstacle.push.at;
        if (obstacle.body >= 0) {
            bump.element = around.names[static_cast<std::size_t>(obstacle.body)];
        } else if (obstacle.element >= 0 && obstacle.element < static_cast<int>(elements.size())) {
            bump.element = elements[static_cast<std::size_t>(obstacle.element)].name;
        }
        bumps.push_back(bump);
    };
    for (const Obstacle& obstacle : m_feelers.feel(around.scene, m_body, m_state.baseInArena)) {
        m_pushes.push_back(obstacle.push);
        touch(obstacle);
    }
    for (const int element : m_footing.victims) {
        Obstacle under;
        under.element = element;
        under.victim = true;
        touch(under);
    }
    m_freeWay = m_pushes.empty() ? std::min(LongestBlindWay, m_feelers.clearance() - 0.003) : 0.0;
    return bumps;
}

std::vector<Bump> Robot::step(const Surroundings& around, double seconds) {
    const Pose before = m_state.baseInArena;
    std::vector<Bump> bumps;
    drawSlip(seconds);
    if (m_state.tipped || m_topple) {
        // The wheels are in the air.
        DriveInput input;
        input.leftVoltage = m_left;
        input.rightVoltage = m_right;
        input.brake = m_brake;
        m_speeds.linear.setZero();
        m_speeds.turn = 0.0;
        m_driveTrain.step(m_speeds, input, {}, seconds);
        if (m_topple) topple(seconds);
    } else {
        bumps = lookForBumps(around, seconds);
        drive(seconds);
        stand(around.scene, seconds);
    }
    const Pose& pose = m_state.baseInArena;
    m_moved = !(pose.matrix().array() == before.matrix().array()).all();
    const Eigen::AngleAxisd turned(before.linear().transpose() * pose.linear());
    m_state.angular =
        m_moved ? Eigen::Vector3d(turned.angle() / seconds * turned.axis()) : Eigen::Vector3d::Zero();
    m_state.linear = pose.linear().transpose() * (pose.translation() - before.translation()) / seconds;
    m_state.left = m_speeds.left;
    m_state.right = m_speeds.right;
    m_state.leftCurrent = m_driveTrain.current(m_left, m_speeds.left);
    m_state.rightCurrent = m_driveTrain.current(m_right, m_speeds.right);
    m_state.travelledLeft += m_speeds.left * seconds;
    m_state.travelledRight += m_speeds.right * seconds;
    m_state.blocked = m_driveTrain.held();
    return bumps;
}

}  // namespace leitstand::simulation
