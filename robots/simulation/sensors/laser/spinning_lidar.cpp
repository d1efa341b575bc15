#include "robots/simulation/sensors/laser/spinning_lidar.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>

#include "core/event/stream_role.h"

namespace leitstand::simulation {

SpinningLidarSettings vlp16() {
    SpinningLidarSettings settings;
    settings.laser.nearest = 0.5;
    settings.laser.farthest = 100.0;
    settings.laser.deviation = 0.01;
    settings.laser.deviationOfRange = 0.0;
    settings.laser.divergence = 0.0015;
    return settings;
}

SpinningLidar::SpinningLidar(const SpinningLidarSettings& settings, const Noise& noise, Time start)
    : m_settings(settings), m_head(settings.laser, noise), m_schedule(settings.rate, start) {
    m_rays.resize(static_cast<std::size_t>(settings.rings) * static_cast<std::size_t>(settings.columns));
}

std::chrono::nanoseconds SpinningLidar::shotAfter(int column) const {
    return std::chrono::nanoseconds(std::llround(column * 1e9 / (m_settings.rate * m_settings.columns)));
}

std::size_t SpinningLidar::indexOf(int ring, int column) const {
    return static_cast<std::size_t>(ring) * static_cast<std::size_t>(m_settings.columns) +
           static_cast<std::size_t>(column);
}

CloudSample SpinningLidar::revolution(const World& world, int robot, Time start) {
    std::vector<Eigen::Vector3f> directions(m_rays.size());
    for (int column = 0; column < m_settings.columns; ++column) {
        const Pose lidar = world.baseInArena(robot, start + shotAfter(column)) * m_settings.lidarInBase;
        // Clockwise, seen from above.
        const double azimuth = -2.0 * std::numbers::pi * column / m_settings.columns;
        for (int ring = 0; ring < m_settings.rings; ++ring) {
            const double elevation = m_settings.lowest + ring * m_settings.ringStep;
            const Eigen::Vector3d direction(std::cos(elevation) * std::cos(azimuth),
                                            std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
            const auto i = indexOf(ring, column);
            directions[i] = direction.cast<float>();
            m_rays[i].origin = lidar.translation().cast<float>();
            m_rays[i].direction = (lidar.linear() * direction).cast<float>();
        }
    }
    const std::span<const LaserEcho> echoes = m_head.measure(m_rays, castInto(world.scene(), RayKind::Laser));
    CloudSample cloud;
    const auto last = shotAfter(m_settings.columns - 1);
    cloud.header = {start + last, m_settings.frame};
    for (int column = 0; column < m_settings.columns; ++column) {
        for (int ring = 0; ring < m_settings.rings; ++ring) {
            const auto i = indexOf(ring, column);
            if (!std::isfinite(echoes[i].range)) continue;
            cloud.points.emplace_back(directions[i] * echoes[i].range);
            cloud.intensities.push_back(echoes[i].intensity);
            cloud.times.push_back((shotAfter(column) - last).count());
            cloud.rings.push_back(ring);
        }
    }
    return cloud;
}

void SpinningLidar::run(const World& world, int robot, std::vector<HardwareSample>& samples) {
    while (const auto start = m_schedule.due(world.now() - shotAfter(m_settings.columns - 1))) {
        samples.push_back({StreamRole::Points, m_settings.sensor, revolution(world, robot, *start),
                           m_enabled ? Reach::Everywhere : Reach::OnBoard});
    }
}

bool SpinningLidar::configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) {
    if (role != StreamRole::Points || sensor != m_settings.sensor) return false;
    m_enabled = settings.enabled;
    return true;
}

}  // namespace leitstand::simulation
