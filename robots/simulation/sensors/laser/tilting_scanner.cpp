#include "robots/simulation/sensors/laser/tilting_scanner.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/event/stream_role.h"

namespace leitstand::simulation {
namespace {

constexpr double StandingSpeed = 0.005;        ///< [m/s]
constexpr double StandingTurn = degrees(0.5);  ///< [rad/s]

bool stands(const BodyState& state) {
    return state.linear.norm() < StandingSpeed && state.angular.norm() < StandingTurn;
}

}  // namespace

TiltingScanner::TiltingScanner(const TiltingScannerSettings& settings, const Noise& noise, Time start)
    : m_settings(settings),
      m_head(settings.laser, noise),
      m_standingSince(start),
      m_start(start + settings.settle) {
    m_rays.resize(static_cast<std::size_t>(settings.columns));
}

Eigen::Vector3d TiltingScanner::direction(const TiltingScannerSettings& settings, int row, int column) {
    const double elevation = settings.highest - settings.down * row / (settings.rows - 1);
    const double angle = settings.across * (0.5 - double(column) / (settings.columns - 1));
    // The plane of the mirror is tilted about the y axis.
    return {std::cos(angle) * std::cos(elevation), std::sin(angle), std::cos(angle) * std::sin(elevation)};
}

std::chrono::nanoseconds TiltingScanner::shotAfter(int row, int column) const {
    return row * m_settings.rawScan + column * m_settings.rawScan / 360;
}

void TiltingScanner::measureRow(const World& world, int robot) {
    const int row = m_sweep.rows;
    const auto aimed = [&](int column) { return direction(m_settings, row, column); };
    const Pose mount = world.baseInArena(robot, m_start + shotAfter(row, 0)) * m_settings.mountInBase;
    for (int column = 0; column < m_settings.columns; ++column) {
        Ray& ray = m_rays[static_cast<std::size_t>(column)];
        ray.origin = mount.translation().cast<float>();
        ray.direction = (mount.linear() * aimed(column)).cast<float>();
    }
    const auto echoes = m_head.measure(m_rays, castInto(world.scene(), RayKind::Laser));
    if (row == 0) m_sweep.header = {m_start, m_settings.frame};
    m_sweep.columns = m_settings.columns;
    ++m_sweep.rows;
    for (int column = 0; column < m_settings.columns; ++column) {
        const LaserEcho& echo = echoes[static_cast<std::size_t>(column)];
        m_sweep.points.emplace_back(aimed(column).cast<float>() * echo.range);
        m_sweep.intensities.push_back(echo.intensity);
        m_sweep.times.push_back(shotAfter(row, column).count());
        m_sweep.rings.push_back(row);
    }
}

void TiltingScanner::run(const World& world, int robot, std::vector<HardwareSample>& samples) {
    if (!stands(world.state(robot)) || !m_enabled) {
        m_standingSince = world.now();
        m_start = m_standingSince + m_settings.settle;
        m_sweep = {};
        return;
    }
    while (m_start + shotAfter(m_sweep.rows, m_settings.columns - 1) <= world.now()) {
        measureRow(world, robot);
        if (m_sweep.rows < m_settings.rows) continue;
        m_start += m_settings.rows * m_settings.rawScan + m_settings.back;
        samples.push_back({StreamRole::Points, m_settings.sensor, std::exchange(m_sweep, {})});
    }
}

bool TiltingScanner::configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) {
    if (role != StreamRole::Points || sensor != m_settings.sensor) return false;
    m_enabled = settings.enabled;
    return true;
}

}  // namespace leitstand::simulation
