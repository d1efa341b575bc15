#include "robots/simulation/world/motion/drive_train.h"

#include <algorithm>
#include <cmath>

namespace leitstand::simulation {
namespace {

constexpr double Gravity = 9.81;  ///< [m/s2]
constexpr int Sweeps = 24;
constexpr double WallFriction = 0.3;
constexpr double BellyFriction = 0.4;
constexpr double AllowedDepth = 0.001;  ///< depth that stays, so that a contact lasts [m]
constexpr double PushOut = 0.1;         ///< highest speed out of an obstacle [m/s]

using Speeds = Eigen::Matrix<double, 5, 1>;  ///< along x, along y, turn, left wheels, right wheels

/// A combination of speeds that an impulse within limits brings to a wanted value.
struct Constraint {
    Speeds row = Speeds::Zero();
    double wanted = 0.0;
    double least = 0.0, most = 0.0;  ///< of the impulse [Ns]
    double impulse = 0.0;

    void solve(Speeds& speeds, const Speeds& inverseMass) {
        const Speeds answer = inverseMass.cwiseProduct(row);
        const double before = impulse;
        impulse = std::clamp(impulse + (wanted - row.dot(speeds)) / row.dot(answer), least, most);
        speeds += (impulse - before) * answer;
    }
    void warm(Speeds& speeds, const Speeds& inverseMass, double start) {
        impulse = std::clamp(start, least, most);
        speeds += impulse * inverseMass.cwiseProduct(row);
    }
};

double reachOf(const BodySpec& spec) {
    double reach = 0.05;
    for (const Eigen::Vector2d& corner : spec.outline) reach = std::max(reach, corner.norm());
    return reach;
}

}  // namespace

DriveTrain::DriveTrain(const BodySpec& spec)
    : m_motor(spec.motor),
      m_mass(spec.mass),
      m_inertia(0.0),
      m_track(spec.trackWidth / std::max(0.1, 1.0 - spec.slip.turning)),
      m_grip(spec.grip),
      m_skidTorque(spec.skidTorque),
      m_reach(reachOf(spec)) {
    m_inertia = m_mass * m_reach * m_reach / 3.0;  // as a box with these corners
}

double DriveTrain::current(double voltage, double speed) const {
    return m_motor.stallCurrent * std::abs(voltage - speed / m_motor.fullSpeed);
}

void DriveTrain::step(DriveState& state, const DriveInput& input, const std::vector<Push>& pushes,
                      double seconds) {
    const double weight = input.leftLoad + input.rightLoad + input.bellyLoad;
    Speeds inverseMass;
    inverseMass << 1.0 / m_mass, 1.0 / m_mass, 1.0 / m_inertia, 1.0 / m_motor.inertia, 1.0 / m_motor.inertia;
    // The motor's force falls with its speed. Taken at the end of the step, it is stable for any step.
    const double push = m_motor.stallForce * seconds / m_motor.inertia;
    const auto driven = [&](double speed, double voltage) {
        return (speed + push * voltage) / (1.0 + push / m_motor.fullSpeed);
    };
    Speeds speeds;
    speeds << state.linear + input.gravity * seconds, state.turn, driven(state.left, input.leftVoltage),
        driven(state.right, input.rightVoltage);

    std::array<Constraint, RowCount> rows;
    const double gear =
        seconds * (m_motor.friction + (input.brake ? 3.0 * m_motor.stallForce + weight : 0.0));
    const auto limit = [&](Row row, double most) {
        rows[row].least = -most;
        rows[row].most = most;
    };
    rows[LeftGear].row << 0, 0, 0, 1, 0;
    limit(LeftGear, gear);
    rows[RightGear].row << 0, 0, 0, 0, 1;
    limit(RightGear, gear);
    rows[LeftGround].row << 1, 0, -0.5 * m_track, -(1.0 - input.leftSlip), 0;
    limit(LeftGround, m_grip * input.leftLoad * seconds);
    rows[RightGround].row << 1, 0, 0.5 * m_track, 0, -(1.0 - input.rightSlip);
    limit(RightGround, m_grip * input.rightLoad * seconds);
    rows[Across].row << 0, 1, 0, 0, 0;
    limit(Across, (m_grip * (input.leftLoad + input.rightLoad) + BellyFriction * input.bellyLoad) * seconds);
    rows[Skid].row << 0, 0, 1, 0, 0;
    limit(Skid, m_skidTorque * weight / (m_mass * Gravity) * seconds);
    Constraint belly;
    belly.row << 1, 0, 0, 0, 0;
    belly.most = BellyFriction * input.bellyLoad * seconds;
    belly.least = -belly.most;

    std::vector<Constraint> walls(2 * pushes.size());
    for (std::size_t i = 0; i < pushes.size(); ++i) {
        const Push& wall = pushes[i];
        const Eigen::Vector2d along(-wall.normal.y(), wall.normal.x());
        const auto rowOf = [&](const Eigen::Vector2d& direction) {
            Speeds row;
            row << direction, wall.at.x() * direction.y() - wall.at.y() * direction.x(), 0, 0;
            return row;
        };
        walls[2 * i].row = rowOf(wall.normal);
        walls[2 * i].wanted = std::clamp((wall.depth - AllowedDepth) / (10.0 * seconds), 0.0, PushOut);
        walls[2 * i].most = 1e9;
        walls[2 * i + 1].row = rowOf(along);
    }
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].warm(speeds, inverseMass, m_impulses[i]);
    for (int sweep = 0; sweep < Sweeps; ++sweep) {
        for (Constraint& row : rows) row.solve(speeds, inverseMass);
        if (belly.most > 0.0) belly.solve(speeds, inverseMass);
        for (std::size_t i = 0; i < pushes.size(); ++i) {
            walls[2 * i].solve(speeds, inverseMass);
            walls[2 * i + 1].most = WallFriction * walls[2 * i].impulse;
            walls[2 * i + 1].least = -walls[2 * i + 1].most;
            walls[2 * i + 1].solve(speeds, inverseMass);
        }
    }
    for (std::size_t i = 0; i < rows.size(); ++i) m_impulses[i] = rows[i].impulse;
    m_held = false;
    for (std::size_t i = 0; i < pushes.size(); ++i) m_held = m_held || walls[2 * i].impulse > 1e-9;
    // Speeds that the sweeps leave at a standstill would creep on for ever.
    constexpr double Standstill = 1e-7;
    speeds = speeds.unaryExpr([](double speed) { return std::abs(speed) < Standstill ? 0.0 : speed; });
    state.linear = speeds.head<2>();
    state.turn = speeds[2];
    state.left = speeds[3];
    state.right = speeds[4];
}

}  // namespace leitstand::simulation
