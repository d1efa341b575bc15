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

SpinningLidarSettings os1() {
    SpinningLidarSettings settings = vlp16();
    settings.laser.nearest = 0.3;
    settings.rings = 32;
    settings.columns = 512;
    settings.lowest = degrees(-22.5);
    settings.ringStep = degrees(45.0 / 31.0);
    settings.noEcho = SpinningLidarSettings::NoEcho::Zeros;
    settings.stamp = SpinningLidarSettings::Stamp::First;
    return settings;
}

SpinningLidarSettings mid360() {
    SpinningLidarSettings settings = vlp16();
    settings.laser.nearest = 0.1;
    settings.laser.farthest = 40.0;
    settings.laser.deviation = 0.02;
    settings.pattern = SpinningLidarSettings::Pattern::Rosette;
    settings.rings = 4;
    settings.columns = 2500;
    settings.lowest = degrees(-7.0);
    settings.ringStep = degrees(59.0);
    settings.noEcho = SpinningLidarSettings::NoEcho::Zeros;
    settings.stamp = SpinningLidarSettings::Stamp::First;
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

Eigen::Vector3d SpinningLidar::directionOf(int ring, int column) const {
    const double share = static_cast<double>(column) / m_settings.columns;
    double around = share, elevation = m_settings.lowest + ring * m_settings.ringStep;
    if (m_settings.pattern == SpinningLidarSettings::Pattern::Rosette) {
        constexpr double UpAndDown = 23.7,
                         Drift = 0.618;  // a revolution; both irrational enough not to repeat
        const auto turns = static_cast<double>(m_revolutions);
        around = 2.0 * share + Drift * turns;
        const double phase = UpAndDown * (share + turns) + static_cast<double>(ring) / m_settings.rings;
        elevation =
            m_settings.lowest + m_settings.ringStep * 0.5 * (1.0 + std::sin(2.0 * std::numbers::pi * phase));
    }
    const double azimuth = -2.0 * std::numbers::pi * around;  // clockwise, seen from above
    return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
            std::sin(elevation)};
}

CloudSample SpinningLidar::revolution(const World& world, int robot, Time start) {
    std::vector<Eigen::Vector3f> directions(m_rays.size());
    for (int column = 0; column < m_settings.columns; ++column) {
        const Pose lidar = world.baseInArena(robot, start + shotAfter(column)) * m_settings.lidarInBase;
        for (int ring = 0; ring < m_settings.rings; ++ring) {
            const Eigen::Vector3d direction = directionOf(ring, column);
            const auto i = indexOf(ring, column);
            directions[i] = direction.cast<float>();
            m_rays[i].origin = lidar.translation().cast<float>();
            m_rays[i].direction = (lidar.linear() * direction).cast<float>();
        }
    }
    const std::span<const LaserEcho> echoes = m_head.measure(m_rays, castInto(world.scene(), RayKind::Laser));
    ++m_revolutions;
    CloudSample cloud;
    const auto stamped = m_settings.stamp == SpinningLidarSettings::Stamp::First
                             ? std::chrono::nanoseconds(0)
                             : shotAfter(m_settings.columns - 1);
    const bool zeros = m_settings.noEcho == SpinningLidarSettings::NoEcho::Zeros;
    cloud.header = {start + stamped, m_settings.frame};
    const auto add = [&](int ring, int column) {
        const auto i = indexOf(ring, column);
        const bool echo = std::isfinite(echoes[i].range);
        if (!echo && !zeros) return;
        cloud.points.emplace_back(directions[i] * (echo ? echoes[i].range : 0.0F));
        cloud.intensities.push_back(echo ? echoes[i].intensity : 0.0F);
        cloud.times.push_back((shotAfter(column) - stamped).count());
        cloud.rings.push_back(ring);
    };
    if (zeros && m_settings.pattern == SpinningLidarSettings::Pattern::Rings) {
        cloud.rows = m_settings.rings;
        cloud.columns = m_settings.columns;
        for (int ring = m_settings.rings - 1; ring >= 0; --ring)  // the highest ring is the first row
            for (int column = 0; column < m_settings.columns; ++column) add(ring, column);
    } else {
        for (int column = 0; column < m_settings.columns; ++column)
            for (int ring = 0; ring < m_settings.rings; ++ring) add(ring, column);
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
