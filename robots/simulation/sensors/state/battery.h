#pragma once

#include <string>

#include "robots/simulation/sensors/noise.h"
#include "robots/simulation/sensors/schedule.h"
#include "robots/simulation/sensors/sensor.h"

namespace leitstand::simulation {

struct BatterySettings {
    double rate = 1.0;                 ///< default and highest rate [Hz]
    double full = 26.0, empty = 21.5;  ///< voltage without load [V]
    double capacity = 9.0;             ///< [Ah]
    double resistance = 0.12;          ///< [ohm]
    double electronics = 3.0;          ///< current of computers and sensors [A]
    double charge = 0.95;              ///< charge at the beginning, as a share of the capacity
    std::string frame;
};

/// Kurt3D: 24 V; the Crawler: 14.4 V.
[[nodiscard]] BatterySettings kurt3dBattery();
[[nodiscard]] BatterySettings crawlerBattery();

/// A battery that is drained by motors and electronics. It reports current, voltage and charge.
class Battery final : public Sensor {
public:
    Battery(const BatterySettings& settings, const Noise& noise, Time start);

    void run(const World& world, int robot, std::vector<HardwareSample>& samples) override;
    bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;

private:
    BatterySettings m_settings;
    Noise m_noise;
    Schedule m_schedule;
    bool m_enabled = true;
    double m_charge;  ///< [Ah]
    Time m_last;
};

}  // namespace leitstand::simulation
