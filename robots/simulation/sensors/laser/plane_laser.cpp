#include "robots/simulation/sensors/laser/plane_laser.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/time.h"
#include "core/event/cloud_sample.h"
#include "core/event/stream_role.h"

namespace leitstand::simulation {

PlaneLaserSettings hokuyoUrg() {
    PlaneLaserSettings settings;
    settings.laser.nearest = 0.06;
    settings.laser.farthest = 4.0;
    settings.laser.deviation = 0.005;
    settings.laser.deviationOfRange = 0.01;
    settings.laser.divergence = 0.003;
    return settings;
}

PlaneLaserSettings rplidarA1() {
    PlaneLaserSettings settings;
    settings.laser.nearest = 0.15;
    settings.laser.farthest = 12.0;
    settings.laser.deviation = 0.003;
    settings.laser.deviationOfRange = 0.01;
    settings.laser.divergence = 0.004;
    settings.points = 1'060;
    settings.first = degrees(-180.0);
    settings.step = degrees(360.0 / settings.points);
    settings.rate = 7.5;
    return settings;
}

PlaneLaser::PlaneLaser(const PlaneLaserSettings& settings, const Noise& noise, Time start)
    : m_settings(settings),
      m_head(settings.laser, noise),
      m_schedule(settings.rate, start),
      m_sent(settings.rate, start) {
    m_rays.resize(static_cast<std::size_t>(settings.points));
}

std::chrono::nanoseconds PlaneLaser::shotAfter(int point) const {
    const double share = point * m_settings.step / (2.0 * std::numbers::pi);  // of a turn of the mirror
    return std::chrono::nanoseconds(std::llround(share * 1e9 / m_settings.rate));
}

RangesSample PlaneLaser::turn(const World& world, int robot, Time stamp) {
    for (int point = 0; point < m_settings.points; ++point) {
        const Pose laser = world.baseInArena(robot, stamp + shotAfter(point)) * m_settings.laserInBase;
        const double angle = m_settings.first + point * m_settings.step;
        Ray& ray = m_rays[static_cast<std::size_t>(point)];
        ray.origin = laser.translation().cast<float>();
        ray.direction =
            (laser.linear() * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0)).cast<float>();
    }
    RangesSample ranges;
    ranges.header = {stamp, m_settings.frame};
    ranges.angleMin = m_settings.first;
    ranges.angleStep = m_settings.step;
    ranges.timeStep = toSeconds(shotAfter(1));
    ranges.turnTime = 1.0 / m_settings.rate;
    ranges.rangeMin = m_settings.laser.nearest;
    ranges.rangeMax = m_settings.laser.farthest;
    ranges.ranges.reserve(m_rays.size());
    for (const LaserEcho& echo : m_head.measure(m_rays, castInto(world.scene(), RayKind::Laser))) {
        ranges.ranges.push_back(echo.range);
    }
    return ranges;
}

void PlaneLaser::run(const World& world, int robot, std::vector<HardwareSample>& samples) {
    while (const auto stamp = m_schedule.due(world.now() - shotAfter(m_settings.points - 1))) {
        bool sent = false;
        while (m_sent.due(*stamp)) sent = m_enabled;
        samples.push_back({StreamRole::Ranges, m_settings.sensor, turn(world, robot, *stamp),
                           sent ? Reach::Everywhere : Reach::OnBoard});
    }
}

bool PlaneLaser::configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) {
    if (role != StreamRole::Ranges || sensor != m_settings.sensor) return false;
    m_enabled = settings.enabled;
    m_sent.setRate(settings.rate > 0.0 ? std::min(settings.rate, m_settings.rate) : m_settings.rate);
    return true;
}

}  // namespace leitstand::simulation
