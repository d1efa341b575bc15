#include "robots/simulation/sensors/state/battery.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/event/status_samples.h"
#include "core/event/stream_role.h"

namespace leitstand::simulation {

BatterySettings kurt3dBattery() {
    return {};
}

BatterySettings crawlerBattery() {
    BatterySettings settings;
    settings.full = 16.4;
    settings.empty = 12.8;
    settings.capacity = 4.0;
    settings.resistance = 0.10;
    settings.electronics = 1.6;
    return settings;
}

Battery::Battery(const BatterySettings& settings, const Noise& noise, Time start)
    : m_settings(settings),
      m_noise(noise),
      m_schedule(settings.rate, start),
      m_charge(settings.charge * settings.capacity),
      m_last(start) {}

void Battery::run(const World& world, int robot, std::vector<HardwareSample>& samples) {
    const BodyState& state = world.state(robot);
    const double current =
        m_settings.electronics + std::abs(state.leftCurrent) + std::abs(state.rightCurrent);
    const double hours = std::chrono::duration<double, std::ratio<3600>>(world.now() - m_last).count();
    m_last = world.now();
    m_charge = std::max(0.0, m_charge - current * hours);
    while (const auto stamp = m_schedule.due(world.now())) {
        if (!m_enabled) continue;
        BatterySample battery;
        battery.header = {*stamp, m_settings.frame};
        battery.charge = m_charge;
        battery.capacity = m_settings.capacity;
        battery.fraction = m_charge / m_settings.capacity;
        battery.current = -current;
        battery.voltage = std::lerp(m_settings.empty, m_settings.full, battery.fraction) -
                          m_settings.resistance * current + 0.01 * m_noise.normal();
        battery.temperature = world.arena().ambient + 0.3 * current;
        battery.status = BatterySample::Status::Discharging;
        battery.location = "base";
        samples.push_back({StreamRole::Battery, {}, battery});
    }
}

bool Battery::configure(StreamRole role, const std::string&, const StreamSettings& settings) {
    if (role != StreamRole::Battery) return false;
    m_enabled = settings.enabled;
    m_schedule.setRate(settings.rate > 0.0 ? std::min(settings.rate, m_settings.rate) : m_settings.rate);
    return true;
}

}  // namespace leitstand::simulation
