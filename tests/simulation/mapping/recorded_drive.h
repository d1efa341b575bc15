#pragma once

#include <cstdint>
#include <vector>

#include "core/cloud/pose_track.h"
#include "core/robot/robot_description.h"
#include "robots/hardware/robot_hardware.h"
#include "robots/simulation/arena/arena.h"

namespace leitstand::simulation::test {

/// What a robot said on a drive that mapping wants to know, and the truth.
struct RecordedDrive {
    struct Received {
        Time at{};  ///< when it was ready
        HardwareSample sample;
    };
    Arena arena;
    RobotDescription robot;
    std::vector<Received> received;  ///< clouds, odometry, inertial unit, in order
    PoseTrack truth;                 ///< base_link in the arena, 100 times a second
    double way = 0.0;                ///< that it drove [m]

    [[nodiscard]] Pose baseInArena(Time stamp) const;
};

/// Whether mapping wants to know it.
[[nodiscard]] bool isForMapping(const HardwareSample& sample);

/// Kurt3D with the tilting scanner of 2004 drives half a metre, stops and sweeps, @p stops times.
[[nodiscard]] RecordedDrive stopScanGo(std::uint64_t seed, int stops);

/// A radio gap from @p from to @p to seconds after the beginning: odometry and inertial unit are lost in it,
/// slices come after it, all at once, every other one twice.
[[nodiscard]] RecordedDrive withRadioGap(RecordedDrive drive, double from, double to);

/// Kurt3D explores the yellow arena of @p seed for @p seconds; when nothing is left to explore it is driven
/// to and fro by hand.
[[nodiscard]] RecordedDrive exploredYellow(std::uint64_t seed, double seconds);

}  // namespace leitstand::simulation::test
