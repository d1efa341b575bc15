#pragma once

#include <string>

#include "robots/simulation/sensors/schedule.h"
#include "robots/simulation/sensors/sensor.h"

namespace leitstand::simulation {

/// A detector of people and signs without errors, as teams run one on their robots: it draws a box and a name
/// around each that is ahead and in sight.
class Detector final : public Sensor {
public:
    /// @p frame: that of its markers, the robot's base.
    Detector(std::string frame, Time start);

    void run(const World& world, int robot, std::vector<HardwareSample>& samples) override;
    bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;

private:
    std::string m_frame;
    Schedule m_schedule;
    bool m_enabled = true;
};

}  // namespace leitstand::simulation
