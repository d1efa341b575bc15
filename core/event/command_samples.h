#pragma once

#include <cstdint>
#include <string>

#include "core/base/time.h"

namespace leitstand {

/// Stops or releases a robot. It is repeated until a StopStateSample has its number (docs/design.md, "The
/// wire").
struct StopCommandSample {
    Time stamp{};                ///< station's clock; only for the log, never compared
    std::string station;         ///< persistent identity of the sending station
    std::uint64_t number = 0;    ///< increases with every command of a station
    bool stop = true;            ///< false: release, which only the holder of the drive grant may send
    std::uint64_t releases = 0;  ///< for a release: StopStateSample::stops that the operator saw last
};

/// Locks or frees a robot's multiplexer of drive commands (std_msgs/msg/Bool), as twist_mux has it: while it
/// is locked, no source below the lock's priority drives the robot, whoever sends.
struct DriveLockSample {
    bool locked = false;
};

/// Requests another mode of a robot.
struct ModeCommandSample {
    Time stamp{};  ///< station's clock
    std::string station;
    std::string mode;  ///< one of ModeSample::available
};

/// Requests another rate or quality of one of a robot's streams.
struct StreamCommandSample {
    Time stamp{};  ///< station's clock
    std::string station;
    std::string topic;    ///< ROS name of the stream, "/kurt3d/left/image/compressed"
    bool enabled = true;  ///< whether it is sent at all
    double rate = 0.0;    ///< highest rate [Hz]; 0: the robot chooses
    int quality = 0;      ///< quality of JPEG, 1 to 100; 0: the robot chooses
    int maxWidth = 0;     ///< wider pictures are scaled down to this [px]; 0: the robot chooses
};

/// Asks a robot for a PongSample.
struct PingSample {
    std::uint64_t number = 0;  ///< increases with every ping of a station
    std::string station;
    Time sent{};  ///< station's clock
};

}  // namespace leitstand
