#include "tests/simulation/mapping/scripted_drive.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/cloud/pose_track.h"
#include "core/mapping/motion/scan_cutter.h"
#include "core/mapping/plane/plane_scan.h"
#include "tests/simulation/drives/driven_world.h"
#include "tests/simulation/mapping/scripted_laser.h"
#include "tests/simulation/mapping/scripted_motion.h"
#include "tests/simulation/mapping/scripted_scanner.h"

namespace leitstand::simulation::test {
namespace {

/// Gives a ScanCutter what a robot says, in the order in which it comes.
class Listener {
public:
    /// @p drifting: what is said; @p within: by which turns are put together, as often.
    Listener(const RobotDescription& robot, const ScannerCorrection& correction,
             const MotionSamples& drifting, const MotionSamples& within)
        : m_robot(robot),
          m_correction(correction),
          m_drifting(drifting),
          m_within(within),
          m_cutter(robot.name) {}

    void receive(CloudSample slice, std::vector<LiveScan>& scans) {
        m_correction.correct(slice);
        receive(std::move(slice), m_correction.corrected(m_robot.sensors.at("scanner").sensorInBase), scans);
    }
    void receive(CloudSample slice, const Pose& sensorInBase, std::vector<LiveScan>& scans) {
        // A slice comes when its last shot is over, and odometry that covers it is there.
        const Time end = endOf(slice);
        const Time now = end + std::chrono::milliseconds(60);
        for (; m_next < m_within.odometry.size() && m_within.odometry[m_next].header.stamp <= now; ++m_next) {
            m_cutter.add(m_within.odometry[m_next], now);
            m_cutter.add(m_within.imu[m_next], m_robot.sensors.at("imu").sensorInBase, now);
            const OdometrySample& sample = m_drifting.odometry[m_next];
            m_drift.add(sample.header.stamp,
                        sample.baseInOdom * m_within.odometry[m_next].baseInOdom.inverse());
        }
        m_cutter.add(std::move(slice), sensorInBase, now);
        keep(m_cutter.take(now), scans);
    }
    void finish(std::vector<LiveScan>& scans) { keep(m_cutter.finish(), scans); }

private:
    void keep(std::vector<LiveScan> more, std::vector<LiveScan>& scans) {
        for (LiveScan& one : more) {
            if (&m_drifting != &m_within) {
                auto scan = std::make_shared<Scan>(*one.scan);
                scan->sensorInOdom = m_drift.at(scan->end).value() * scan->sensorInOdom;
                one.scan = std::move(scan);
            }
            scans.push_back(std::move(one));
        }
    }
    const RobotDescription& m_robot;
    const ScannerCorrection m_correction;
    const MotionSamples &m_drifting, &m_within;
    PoseTrack m_drift;  ///< of odometry that drifts from one that does not
    std::size_t m_next = 0;
    ScanCutter m_cutter;
};

/// Returns the drive of @p robot, a shipped one, without scans.
ScriptedDrive driveOf(const Arena& arena, const std::string& robot, const ScriptedMotion& motion) {
    ScriptedDrive result;
    result.drive.arena = arena;
    result.drive.robot = shippedRobot(robot);
    for (std::int64_t i = 0; static_cast<double>(i) / 100.0 <= motion.duration() + 1.0; ++i) {
        const Time stamp = ScriptBegin + std::chrono::milliseconds(10 * i);
        result.drive.truth.add(stamp, motion.baseAt(stamp));
    }
    result.drive.way = motion.length();
    return result;
}

}  // namespace

SensorErrors realScanner() {
    SensorErrors errors;
    errors.rangeBias = 0.02;
    errors.axisLean = degrees(0.3);
    errors.bendAhead = 0.01;
    errors.bendLeft = degrees(0.25);
    errors.reach = 12.0;
    return errors;
}

SensorErrors worseScanner() {
    SensorErrors errors = realScanner();
    errors.rangeBias = 0.03;
    errors.axisLean = degrees(0.5);
    errors.bendAhead *= 3.0;
    errors.bendLeft *= 3.0;
    errors.reach = 8.0;
    return errors;
}

SensorErrors withRoughMount(SensorErrors errors) {
    errors.mountShift = {0.006, -0.006, 0.005};
    errors.mountTurn = {degrees(0.3), degrees(-0.3), degrees(0.3)};
    return errors;
}

ScriptedDrive scriptedDrive(const Arena& arena, const DrivePath& path, const ScriptSettings& settings) {
    constexpr int Batch = 32;  // turns: slices are large
    const ScriptedMotion motion(path, settings);
    ScriptedDrive result = driveOf(arena, "kurt3d", motion);
    const RobotDescription& robot = result.drive.robot;
    const MotionSamples drifting = motionSamples(motion, settings.odometry, settings.seed);
    const MotionSamples exact = motionSamples(motion, {0.0, 0.0, 0.0, 0.0}, settings.seed);
    Listener listener(robot, settings.correction, drifting, settings.driftBendsTurns ? drifting : exact);
    ScriptedScanner scanner(arena, motion, robot.sensors.at("scanner").sensorInBase, settings);
    for (int first = 0; first < scanner.turns(); first += Batch) {
        for (auto& turn : scanner.slices(first, std::min(first + Batch, scanner.turns()))) {
            for (CloudSample& slice : turn) listener.receive(std::move(slice), result.scans);
        }
    }
    listener.finish(result.scans);
    return result;
}

ScriptedDrive scriptedDrive(const Arena& arena, const DrivePath& path, const ScriptSettings& settings,
                            PlaneLaserSettings laser) {
    const ScriptedMotion motion(path, settings);
    ScriptedDrive result = driveOf(arena, "turtlebot4", motion);
    const RobotDescription& robot = result.drive.robot;
    const SensorDescription& mounted = robot.sensors.at("laser");
    laser.laserInBase = mounted.sensorInBase;
    laser.frame = mounted.frame;
    const MotionSamples drifting = motionSamples(motion, settings.odometry, settings.seed);
    Listener listener(robot, settings.correction, drifting, drifting);
    for (const RangesSample& turn : scriptedTurns(arena, motion, laser, settings.seed))
        listener.receive(cloudOf(turn, laser.laserInBase), uprightLaser(laser.laserInBase), result.scans);
    listener.finish(result.scans);
    return result;
}

}  // namespace leitstand::simulation::test
