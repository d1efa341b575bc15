#include "robots/simulation/sensors/state/reading_sensor.h"

#include <algorithm>
#include <cmath>

#include "core/event/status_samples.h"
#include "core/event/stream_role.h"

namespace leitstand::simulation {
namespace {

constexpr double Latitude = 51.7, Longitude = 8.75;  ///< of the arena's origin [degrees]
constexpr double MetresOfADegree = 111'320.0;        ///< of latitude
constexpr double SonarReach = 4.0;                   ///< [m]
constexpr double PressureFall = 0.12;                ///< of the air with height [hPa/m]

}  // namespace

ReadingSensor::ReadingSensor(const ReadingSensorSettings& settings, const Noise& noise, Time start)
    : m_settings(settings), m_noise(noise), m_schedule(settings.rate, start) {}

std::vector<double> ReadingSensor::measured(const World& world, int robot, const Pose& sensor) {
    const auto about = [this](double value, double deviation) {
        return value + deviation * m_noise.normal();
    };
    const Eigen::Vector3d place = sensor.translation();
    const std::string& type = m_settings.type;
    if (type == "sensor_msgs/msg/Temperature") return {about(22.0, 0.05)};
    if (type == "sensor_msgs/msg/RelativeHumidity") return {about(45.0, 0.2)};
    if (type == "sensor_msgs/msg/FluidPressure") return {about(1013.25 - PressureFall * place.z(), 0.02)};
    if (type == "sensor_msgs/msg/MagneticField") return {about(49.2, 0.3)};
    if (type == "sensor_msgs/msg/Illuminance") return {about(300.0, 3.0)};
    if (type == "sensor_msgs/msg/Range") {
        Ray ray;
        ray.origin = place.cast<float>();
        ray.direction = (sensor.linear() * Eigen::Vector3d::UnitX()).cast<float>();
        ray.far = static_cast<float>(SonarReach);
        const Hit hit = world.scene().cast(ray, RayKind::Contact, robot);
        return {hit.there() ? about(hit.distance, 0.01) : std::numeric_limits<double>::infinity()};
    }
    if (type == "sensor_msgs/msg/NavSatFix") {
        const double across = MetresOfADegree * std::cos(degrees(Latitude));
        return {Latitude + place.y() / MetresOfADegree, Longitude + place.x() / across,
                about(110.0 + place.z(), 0.3)};
    }
    return {};
}

void ReadingSensor::run(const World& world, int robot, std::vector<HardwareSample>& samples) {
    while (const auto stamp = m_schedule.due(world.now())) {
        if (!m_enabled) continue;
        const Pose sensor = world.baseInArena(robot, *stamp) * m_settings.sensorInBase;
        ReadingSample reading{{*stamp, m_settings.frame}, measured(world, robot, sensor)};
        samples.push_back({StreamRole::Reading, m_settings.sensor, std::move(reading)});
    }
}

bool ReadingSensor::configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) {
    if (role != StreamRole::Reading || sensor != m_settings.sensor) return false;
    m_enabled = settings.enabled;
    m_schedule.setRate(settings.rate > 0.0 ? std::min(settings.rate, m_settings.rate) : m_settings.rate);
    return true;
}

}  // namespace leitstand::simulation
