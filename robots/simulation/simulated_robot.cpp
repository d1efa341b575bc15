#include "robots/simulation/simulated_robot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/event/all_samples.h"

namespace leitstand::simulation {
namespace {

Time stampOf(const HardwareSample& sample) {
    return visit(
        [](const auto& kind) -> Time {
            if constexpr (requires { kind.header.stamp; }) {
                return kind.header.stamp;
            } else if constexpr (requires { kind.transforms; }) {
                return kind.transforms.empty() ? Time{} : kind.transforms.front().header.stamp;
            } else {
                return Time{};
            }
        },
        sample.sample);
}

double voltage(double value) {
    return std::isfinite(value) ? std::clamp(value, -1.0, 1.0) : 0.0;
}

}  // namespace

SimulatedRobot::SimulatedRobot(World& world, int robot, PanTiltUnits units,
                               std::vector<std::unique_ptr<Sensor>> sensors)
    : m_world(world), m_robot(robot), m_units(std::move(units)), m_sensors(std::move(sensors)) {}

Time SimulatedRobot::now() const {
    return m_world.now();
}

std::vector<HardwareSample> SimulatedRobot::take() {
    for (const auto& [name, mounted] : m_units) mounted->unit.advance(m_world.now());
    std::vector<HardwareSample> samples;
    for (const auto& sensor : m_sensors) sensor->run(m_world, m_robot, samples);
    std::stable_sort(samples.begin(), samples.end(), [](const HardwareSample& a, const HardwareSample& b) {
        return stampOf(a) < stampOf(b);
    });
    return samples;
}

TrackState SimulatedRobot::tracks() const {
    const BodyState& state = m_world.state(m_robot);
    return {state.left, state.right, state.leftCurrent, state.rightCurrent};
}

void SimulatedRobot::setMotors(double left, double right) {
    m_world.setMotors(m_robot, voltage(left), voltage(right));
}

void SimulatedRobot::setBrake(bool on) {
    m_world.setBrake(m_robot, on);
}

void SimulatedRobot::setPanTilt(const std::string& unit, double pan, double tilt) {
    const auto found = m_units.find(unit);
    if (found != m_units.end()) found->second->unit.setTarget(pan, tilt);
}

void SimulatedRobot::setStream(StreamRole role, const std::string& sensor, const StreamSettings& settings) {
    for (const auto& one : m_sensors) (void)one->configure(role, sensor, settings);
}

}  // namespace leitstand::simulation
