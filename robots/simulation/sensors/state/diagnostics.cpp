#include "robots/simulation/sensors/state/diagnostics.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/event/status_samples.h"
#include "core/event/stream_role.h"

namespace leitstand::simulation {
namespace {

constexpr double StalledCurrent = 0.7;  ///< share of the stall current
constexpr std::chrono::milliseconds StallTime(800);
constexpr double Lying = degrees(60);  ///< tilt at which it lies on its side [rad]

DiagnosticStatus driveStatus(const BodyState& state, bool stalled) {
    DiagnosticStatus status;
    status.name = "drive";
    status.level = stalled ? DiagnosticStatus::Level::Warning : DiagnosticStatus::Level::Ok;
    status.message = stalled ? "motors stall" : "ok";
    status.values = {{"left current [A]", fmt::format("{:.2f}", state.leftCurrent)},
                     {"right current [A]", fmt::format("{:.2f}", state.rightCurrent)},
                     {"left speed [m/s]", fmt::format("{:.3f}", state.left)},
                     {"right speed [m/s]", fmt::format("{:.3f}", state.right)}};
    return status;
}

DiagnosticStatus attitudeStatus(const BodyState& state) {
    const double tilt = std::acos(std::clamp(state.baseInArena.linear()(2, 2), -1.0, 1.0));
    DiagnosticStatus status;
    status.name = "attitude";
    status.level = tilt > Lying ? DiagnosticStatus::Level::Error : DiagnosticStatus::Level::Ok;
    status.message = tilt > Lying ? "tipped over" : "ok";
    status.values = {{"tilt [deg]", fmt::format("{:.1f}", inDegrees(tilt))}};
    return status;
}

}  // namespace

Diagnostics::Diagnostics(std::string hardware, Time start)
    : m_hardware(std::move(hardware)), m_schedule(1.0, start), m_notStalled(start) {}

void Diagnostics::run(const World& world, int robot, std::vector<HardwareSample>& samples) {
    const BodyState& state = world.state(robot);
    const double current = std::max(std::abs(state.leftCurrent), std::abs(state.rightCurrent));
    if (current < StalledCurrent * world.spec(robot).motor.stallCurrent) m_notStalled = world.now();
    while (const auto stamp = m_schedule.due(world.now())) {
        if (!m_enabled) continue;
        DiagnosticsSample sample;
        sample.header.stamp = *stamp;
        sample.statuses = {driveStatus(state, world.now() - m_notStalled > StallTime), attitudeStatus(state)};
        for (DiagnosticStatus& status : sample.statuses) status.hardwareId = m_hardware;
        samples.push_back({StreamRole::Diagnostics, {}, std::move(sample)});
    }
}

bool Diagnostics::configure(StreamRole role, const std::string&, const StreamSettings& settings) {
    if (role != StreamRole::Diagnostics) return false;
    m_enabled = settings.enabled;
    if (settings.rate > 0.0) m_schedule.setRate(std::min(settings.rate, 1.0));
    return true;
}

}  // namespace leitstand::simulation
