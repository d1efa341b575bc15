#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/mapping/live/map/live_scan.h"
#include "core/robot/scanner_correction.h"
#include "robots/simulation/sensors/laser/laser_head.h"
#include "robots/simulation/sensors/laser/plane_laser.h"
#include "tests/simulation/mapping/drive_path.h"
#include "tests/simulation/mapping/recorded_drive.h"

namespace leitstand::simulation::test {

/// How a real scanner differs from what its driver says of it.
struct SensorErrors {
    double rangeNoise = 0.01;  ///< deviation of a range [m]
    double rangeBias = 0.0;    ///< all ranges are too long by that [m]
    double axisLean = 0.0;     ///< of the turning axis, to the left and ahead [rad]
    Eigen::Vector3d mountShift = Eigen::Vector3d::Zero();  ///< scanner from where its file says it is [m]
    Eigen::Vector3d mountTurn = Eigen::Vector3d::Zero();   ///< likewise: roll, pitch, yaw [rad]
    double clockLate = 0.0;  ///< its stamps are later than the odometry's by that [s]
    /// Distortion: from its first to its last shot a turn is bent as if the robot had gone so much farther
    /// ahead and to the left than its odometry says.
    double bendAhead = 0.0;  ///< [m]
    double bendLeft = 0.0;   ///< [rad]
    double reach = 30.0;     ///< of a bright surface, seen straight [m]
};
/// 2 cm range bias, axis leaning by 0.3 degrees, 1 cm and 0.25 degrees of distortion in a turn, 12 m reach.
[[nodiscard]] SensorErrors realScanner();
/// 3 cm, 0.5 degrees, three times the distortion, 8 m.
[[nodiscard]] SensorErrors worseScanner();
/// The mount is known to 1 cm and 0.5 degrees only.
[[nodiscard]] SensorErrors withRoughMount(SensorErrors errors);

/// How odometry drifts.
struct OdometryErrors {
    double scale = 0.025;                ///< the way is told too long by this share
    double headingBias = degrees(0.04);  ///< for each metre [rad]
    double headingNoise = degrees(0.1);  ///< for the root of each metre [rad]
    double wayNoise = 0.01;              ///< of each step of 1/20 s, as a share of it
};

struct ScriptSettings {
    double speed = 0.157;      ///< [m/s]: 0.36 m a turn of the scanner
    double scanSpacing = 0.0;  ///< turns that begin nearer to the last one are not sent; 0: all are [m]
    double longest = std::numeric_limits<double>::infinity();  ///< the drive ends after that way [m]
    SensorErrors sensor;
    ScannerCorrection correction;  ///< of what the scanner says
    OdometryErrors odometry;
    /// Whether points are moved within a turn by that odometry, so that its drift bends turns, as on a robot;
    /// otherwise by the truth, so that turns are bent as `sensor` says and no more.
    bool driftBendsTurns = true;
    std::uint64_t seed = 1;  ///< of all noise
};

/// A drive without physics, window and clock, and the truth beside.
struct ScriptedDrive {
    RecordedDrive drive;          ///< arena, robot, truth, way; nothing in `received`
    std::vector<LiveScan> scans;  ///< as ScanCutter makes them of slices, odometry and inertial unit
};

/// Kurt3D with its turning scanner stands for 3 s and then goes along @p path. Each shot is cast from where
/// the scanner is at that instant, people walk meanwhile. The same for the same arguments, whatever the
/// number of threads. Echoes have no intensities.
[[nodiscard]] ScriptedDrive scriptedDrive(const Arena& arena, const DrivePath& path,
                                          const ScriptSettings& settings = {});

/// The same for a TurtleBot 4, which maps with @p laser: its mounting is that of the robot's file.
[[nodiscard]] ScriptedDrive scriptedDrive(const Arena& arena, const DrivePath& path,
                                          const ScriptSettings& settings, PlaneLaserSettings laser);

}  // namespace leitstand::simulation::test
