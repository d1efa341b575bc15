#include "robots/simulation/sensors/state/gas_sensor.h"

#include <algorithm>
#include <cmath>

#include "core/event/status_samples.h"
#include "core/event/stream_role.h"

namespace leitstand::simulation {
namespace {

constexpr double TickRate = 2.0;  ///< how often the air is sampled [Hz]
constexpr double OwnBody = 0.35;  ///< so near its mouth, a victim's own body hides nothing [m]

}  // namespace

double GasLag::step(double ppm, double seconds) {
    m_value += (ppm - m_value) * (1.0 - std::exp(-seconds / m_timeConstant));
    return m_value;
}

double plumeShare(const GasSettings& settings, double distance, bool inSight) {
    if (distance > settings.plumeReach) return 0.0;
    const double thinned = distance / settings.plumeRadius;
    return (inSight ? 1.0 : settings.aroundCorners) / (1.0 + thinned * thinned);
}

GasSensor::GasSensor(const GasSettings& settings, const Noise& noise, Time start)
    : m_settings(settings),
      m_noise(noise),
      m_ticks(TickRate, start),
      m_schedule(settings.rate, start),
      m_lag(settings.lag, settings.base) {}

double GasSensor::concentration(const World& world, int robot, const Eigen::Vector3d& position) const {
    double ppm = m_settings.base;
    for (const Element& element : world.arena().elements) {
        if (!element.victim || !(element.victim->co2 > 0.0)) continue;
        const Eigen::Vector3d mouth = mouthOf(element);
        const double distance = (mouth - position).norm();
        if (distance > m_settings.plumeReach || !(distance > 0.0)) continue;
        Ray ray;
        ray.origin = position.cast<float>();
        ray.direction = ((mouth - position) / distance).cast<float>();
        ray.far = static_cast<float>(distance - OwnBody);
        const bool inSight = distance < OwnBody || !world.scene().cast(ray, RayKind::Contact, robot).there();
        ppm += element.victim->co2 * plumeShare(m_settings, distance, inSight);
    }
    return ppm;
}

void GasSensor::run(const World& world, int robot, std::vector<HardwareSample>& samples) {
    while (const auto tick = m_ticks.due(world.now())) {
        const Pose sensor = world.baseInArena(robot, *tick) * m_settings.sensorInBase;
        m_lag.step(concentration(world, robot, sensor.translation()), 1.0 / TickRate);
        while (const auto stamp = m_schedule.due(*tick)) {
            if (!m_enabled) continue;
            GasSample gas;
            gas.header = {*stamp, m_settings.frame};
            const double deviation = m_settings.noise + m_settings.noiseOfValue * m_lag.value();
            gas.ppm = std::max(0.0, m_lag.value() + deviation * m_noise.normal());
            samples.push_back({StreamRole::Gas, m_settings.sensor, gas});
        }
    }
}

bool GasSensor::configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) {
    if (role != StreamRole::Gas || sensor != m_settings.sensor) return false;
    m_enabled = settings.enabled;
    m_schedule.setRate(settings.rate > 0.0 ? std::min(settings.rate, m_settings.rate) : m_settings.rate);
    return true;
}

}  // namespace leitstand::simulation
