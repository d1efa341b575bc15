#pragma once

#include <atomic>
#include <string>

#include "core/base/result.h"

namespace leitstand::test {

/// A robot that stands for a real one in tests: says sweeps as PointCloud2 in its laser's frame, odometry at
/// 50 Hz, where its laser sits (tf_static), and listens to drive commands, which it echoes to nobody.
struct TestRobotSettings {
    int domain = 0;
    std::string name = "kurt3d";
    std::string scans;          ///< folder of uos scans with odometry; empty: three generated rooms
    int slices = 1;             ///< parts that each sweep is cut into, for yawing sweeps
    double pauseSeconds = 0.3;  ///< between clouds
    std::string keys;           ///< folder of its identity; empty: unsecured
    int waitForReaders = 1;     ///< of the clouds, before the first is said
};

/// Says all scans once, then stays and keeps saying odometry until @p stopped. Prints "said N" on stdout when
/// all clouds are acknowledged.
[[nodiscard]] Result<void> runTestRobot(const TestRobotSettings& settings, const std::atomic<bool>& stopped);

}  // namespace leitstand::test
