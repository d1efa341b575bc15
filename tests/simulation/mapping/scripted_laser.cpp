#include "tests/simulation/mapping/scripted_laser.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "robots/simulation/scene/scene.h"
#include "robots/simulation/sensors/laser/laser_head.h"

namespace leitstand::simulation::test {

std::vector<RangesSample> scriptedTurns(const Arena& arena, const ScriptedMotion& motion,
                                        const PlaneLaserSettings& laser, std::uint64_t seed) {
    Scene scene(arena);
    const CastRays cast = castInto(scene, RayKind::Laser);
    LaserHead head(laser.laser, Noise(seed, "scripted laser"));
    std::vector<Ray> rays(static_cast<std::size_t>(laser.points));
    const double shot =
        std::abs(laser.step) / (2.0 * std::numbers::pi * laser.rate);  // from one to the next [s]
    std::vector<RangesSample> turns;
    for (int number = 0; (number + 1) / laser.rate <= motion.duration(); ++number) {
        const double start = number / laser.rate;
        scene.setTime(start);
        scene.commit();
        for (int point = 0; point < laser.points; ++point) {
            const Pose mount = motion.baseAt(start + point * shot) * laser.laserInBase;
            const double angle = laser.first + point * laser.step;
            Ray& ray = rays[static_cast<std::size_t>(point)];
            ray.origin = mount.translation().cast<float>();
            ray.direction =
                (mount.linear() * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0)).cast<float>();
        }
        RangesSample turn;
        turn.header = {ScriptBegin + std::chrono::nanoseconds(std::llround(1e9 * start)), laser.frame};
        turn.angleMin = laser.first;
        turn.angleStep = laser.step;
        turn.timeStep = shot;
        turn.turnTime = 1.0 / laser.rate;
        turn.rangeMin = laser.laser.nearest;
        turn.rangeMax = laser.laser.farthest;
        for (const LaserEcho& echo : head.measure(rays, cast)) turn.ranges.push_back(echo.range);
        turns.push_back(std::move(turn));
    }
    return turns;
}

}  // namespace leitstand::simulation::test
