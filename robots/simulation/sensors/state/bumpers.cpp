#include "robots/simulation/sensors/state/bumpers.h"

#include <chrono>
#include <cmath>
#include <utility>

#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/robot/robot_format.h"

namespace leitstand::simulation {
namespace {

constexpr std::array<const char*, 4> Names = {robot_format::Front, robot_format::Left, robot_format::Rear,
                                              robot_format::Right};
constexpr std::chrono::milliseconds Pressed(300);  ///< shortest time that a side stays pressed

/// Returns the side that faces @p where, for a robot longer than it is wide.
std::size_t sideOf(const Eigen::Vector2d& where) {
    const double angle = std::atan2(where.y(), where.x());
    return static_cast<std::size_t>(std::lround(angle / degrees(90)) + 4) % 4;
}

}  // namespace

Bumpers::Bumpers(std::string frame) : m_frame(std::move(frame)) {}

void Bumpers::run(const World& world, int robot, std::vector<HardwareSample>& samples) {
    bool changed = !m_reported;
    for (const auto& bumps = world.bumps(); m_seen < bumps.size(); ++m_seen) {
        const Bump& bump = bumps[m_seen];
        if (bump.robot != robot) continue;
        Side& side = m_sides[sideOf(bump.where)];
        side.hit = bump.at;
        side.pressed = true;
        ++side.hits;
        changed = true;
    }
    for (Side& side : m_sides) {
        if (!side.pressed || world.now() - side.hit < Pressed || world.state(robot).blocked) continue;
        side.pressed = false;
        changed = true;
    }
    if (!changed || !m_enabled) return;
    BumpSample sample;
    sample.header = {world.now(), m_frame};
    for (std::size_t i = 0; i < m_sides.size(); ++i) {
        sample.bumpers.push_back({Names[i], m_sides[i].pressed, m_sides[i].hits});
    }
    samples.push_back({StreamRole::Bumps, {}, std::move(sample)});
    m_reported = true;
}

bool Bumpers::configure(StreamRole role, const std::string&, const StreamSettings& settings) {
    if (role != StreamRole::Bumps) return false;
    m_enabled = settings.enabled;
    m_reported = false;
    return true;
}

}  // namespace leitstand::simulation
