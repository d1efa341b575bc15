#pragma once

#include <string>

#include "robots/simulation/sensors/noise.h"
#include "robots/simulation/sensors/schedule.h"
#include "robots/simulation/sensors/sensor.h"

namespace leitstand::simulation {

/// A sensor whose samples are ReadingSample: what it measures follows from the type of its messages
/// (usualReadings()).
struct ReadingSensorSettings {
    std::string type;   ///< "sensor_msgs/msg/Temperature"
    double rate = 2.0;  ///< [Hz]
    std::string sensor, frame;
    Pose sensorInBase = Pose::Identity();
};

/// Measures the air, the distance ahead, the light, the earth's magnetic field or the place on earth, as
/// sensors of these kinds do.
class ReadingSensor final : public Sensor {
public:
    ReadingSensor(const ReadingSensorSettings& settings, const Noise& noise, Time start);

    void run(const World& world, int robot, std::vector<HardwareSample>& samples) override;
    bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;

private:
    [[nodiscard]] std::vector<double> measured(const World& world, int robot, const Pose& sensor);

    ReadingSensorSettings m_settings;
    Noise m_noise;
    Schedule m_schedule;
    bool m_enabled = true;
};

}  // namespace leitstand::simulation
