#pragma once

#include <cstdint>
#include <string>

#include "core/base/time.h"

namespace leitstand {

/// Stops or releases a robot; repeated until a StopStateSample carries its number (docs/design.md, "The
/// wire").
struct StopCommandSample {
    Time stamp{};                ///< station's clock, for the log only: never compared
    std::string station;         ///< identity of the sender
    std::uint64_t number = 0;    ///< rises with every command of a station
    bool stop = true;            ///< false: release, allowed only to the holder of the drive grant
    std::uint64_t releases = 0;  ///< for a release: StopStateSample::stops that its operator saw last
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
    double rate = 0.0;    ///< [Hz]; 0: the robot chooses
    int quality = 0;      ///< of JPEG, 1 to 100; 0: the robot chooses
    int maxWidth = 0;     ///< wider pictures are reduced [px]; 0: the robot chooses
};

/// Requests a PongSample.
struct PingSample {
    std::uint64_t number = 0;  ///< rises with every ping of a station
    std::string station;
    Time sent{};  ///< station's clock
};

}  // namespace leitstand
