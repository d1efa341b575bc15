#pragma once

#include <string>

#include "robots/simulation/sensors/schedule.h"
#include "robots/simulation/sensors/sensor.h"

namespace leitstand::simulation {

/// Reports the state of the robot's drive and attitude once a second.
class Diagnostics final : public Sensor {
public:
    /// @p hardware: hardware_id of all statuses.
    Diagnostics(std::string hardware, Time start);

    void run(const World& world, int robot, std::vector<HardwareSample>& samples) override;
    bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;

private:
    std::string m_hardware;
    Schedule m_schedule;
    bool m_enabled = true;
    Time m_notStalled;  ///< when the motors were last not stalled
};

}  // namespace leitstand::simulation
