#include "tests/simulation/mapping/scripted_scanner.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "robots/simulation/scene/scene.h"
#include "robots/simulation/sensors/laser/turning_pattern.h"

namespace leitstand::simulation::test {
namespace {

using std::chrono::nanoseconds;

double secondsOf(nanoseconds time) {
    return std::chrono::duration<double>(time).count();
}

Pose trueMount(const Pose& reported, const SensorErrors& errors) {
    Pose mount = reported * poseFrom(errors.mountShift, errors.mountTurn.x(), errors.mountTurn.y(),
                                     errors.mountTurn.z());
    const double each = errors.axisLean / std::sqrt(2.0);
    mount.rotate(poseFrom(Eigen::Vector3d::Zero(), -each, each, 0.0).linear());
    return mount;
}

LaserSettings laserOf(const SensorErrors& errors) {
    LaserSettings laser;
    laser.deviation = errors.rangeNoise;
    laser.deviationOfRange = 0.0;
    laser.farthest = errors.reach;
    return laser;
}

}  // namespace

/// A scene for each thread: people stand somewhere else in each turn.
struct ScriptedScanner::Scenes {
    explicit Scenes(const Arena& arena) : of([&arena] { return std::make_unique<Scene>(arena); }) {}
    tbb::enumerable_thread_specific<std::unique_ptr<Scene>> of;
};

ScriptedScanner::ScriptedScanner(const Arena& arena, const ScriptedMotion& motion, const Pose& mountInBase,
                                 const ScriptSettings& settings)
    : m_arena(arena),
      m_motion(motion),
      m_mountInBase(mountInBase),
      m_trueMountInBase(trueMount(mountInBase, settings.sensor)),
      m_settings(settings),
      m_scenes(std::make_unique<Scenes>(arena)) {
    const double turn = secondsOf(TurningPattern().turn);
    double last = 0.0;
    for (std::int64_t number = 0; static_cast<double>(number + 1) * turn <= motion.duration(); ++number) {
        const double way = motion.way(static_cast<double>(number) * turn);
        if (!m_sent.empty() && way - last < settings.scanSpacing) continue;
        m_sent.push_back(number);
        last = way;
    }
}

ScriptedScanner::~ScriptedScanner() = default;

std::vector<std::vector<CloudSample>> ScriptedScanner::slices(int first, int last) {
    std::vector<std::vector<CloudSample>> all(static_cast<std::size_t>(last - first));
    tbb::parallel_for(std::size_t{0}, all.size(),
                      [&](std::size_t i) { all[i] = turn(m_sent[static_cast<std::size_t>(first) + i]); });
    return all;
}

std::vector<CloudSample> ScriptedScanner::turn(std::int64_t number) const {
    const TurningPattern pattern;
    const SensorErrors& errors = m_settings.sensor;
    Scene& scene = *m_scenes->of.local();
    const auto headOf = [&](std::int64_t turn) {
        return LaserHead(laserOf(errors), Noise(m_settings.seed, "scripted turn " + std::to_string(turn)));
    };
    LaserHead head = headOf(number), next = headOf(number + 1);
    const CastRays cast = castInto(scene, RayKind::Laser);
    std::vector<Ray> rays(static_cast<std::size_t>(pattern.points));
    std::vector<CloudSample> slices;
    const std::int64_t begin = number * pattern.rawScans;
    const nanoseconds late(std::llround(1e9 * errors.clockLate));
    const Pose baseInMount = m_mountInBase.inverse();
    for (int row = 0; row <= pattern.rawScans; ++row) {
        // The last raw scan closes the turn; it is the first one of the next, measured once.
        const bool closes = row == pattern.rawScans;
        const std::int64_t rawScan = begin + row;
        const nanoseconds start = pattern.startOf(rawScan);
        scene.setTime(secondsOf(start));
        scene.commit();
        for (int point = 0; point < pattern.points; ++point) {
            const Pose mount =
                m_motion.baseAt(secondsOf(start + pattern.shotAfter(point))) * m_trueMountInBase;
            Ray& ray = rays[static_cast<std::size_t>(point)];
            ray.origin = mount.translation().cast<float>();
            ray.direction = (mount.linear() * pattern.direction(rawScan, point)).cast<float>();
        }
        const auto echoes = (closes ? next : head).measure(rays, cast);
        if (!closes && (slices.empty() || pattern.sliceOf(rawScan) != pattern.sliceOf(rawScan - 1))) {
            slices.emplace_back().header = {ScriptBegin + start + late, "laser"};
            slices.back().columns = pattern.points;
        }
        CloudSample& slice = slices.back();
        ++slice.rows;
        // Bent about its middle.
        const double share = static_cast<double>(row) / pattern.rawScans - 0.5;
        const Pose bend = baseInMount *
                          poseFrom({share * errors.bendAhead, 0.0, 0.0}, 0.0, 0.0, share * errors.bendLeft) *
                          m_mountInBase;
        for (int point = 0; point < pattern.points; ++point) {
            const double range =
                static_cast<double>(echoes[static_cast<std::size_t>(point)].range) + errors.rangeBias;
            slice.points.push_back((bend * (range * pattern.direction(rawScan, point))).cast<float>());
            slice.times.push_back(
                (ScriptBegin + start + late + pattern.shotAfter(point) - slice.header.stamp).count());
            slice.rings.push_back(row);
        }
    }
    return slices;
}

}  // namespace leitstand::simulation::test
