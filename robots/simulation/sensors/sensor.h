#pragma once

#include <vector>

#include "robots/hardware/robot_hardware.h"
#include "robots/simulation/world/world.h"

namespace leitstand::simulation {

/// A sensor of a simulated robot.
class Sensor {
public:
    virtual ~Sensor() = default;
    /// Measures what is due up to world.now() and appends it to @p samples.
    virtual void run(const World& world, int robot, std::vector<HardwareSample>& samples) = 0;
    /// Sets rate and quality of a stream, or switches it on or off. Returns false if the stream with @p role
    /// and @p sensor is not from this sensor.
    virtual bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) = 0;
};

}  // namespace leitstand::simulation
