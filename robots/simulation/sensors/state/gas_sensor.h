#pragma once

#include <string>
#include <vector>

#include "robots/simulation/sensors/noise.h"
#include "robots/simulation/sensors/schedule.h"
#include "robots/simulation/sensors/sensor.h"

namespace leitstand::simulation {

/// How air and its sensor behave.
struct GasSettings {
    double rate = 1.0;            ///< own and highest [Hz]
    double base = 400.0;          ///< of the air [ppm]
    double plumeRadius = 0.4;     ///< where a breath is thinned to half [m]
    double plumeReach = 4.0;      ///< nothing comes farther [m]
    double aroundCorners = 0.15;  ///< share that comes where the mouth is not in sight
    double lag = 10.0;            ///< time constant of the sensor [s]
    double noise = 8.0;           ///< [ppm]
    double noiseOfValue = 0.01;   ///< and more, as a share of what it shows
    std::string sensor, frame;
    Pose sensorInBase = Pose::Identity();
};

/// A sensor that follows what is there only slowly.
class GasLag {
public:
    explicit GasLag(double timeConstant, double value) : m_timeConstant(timeConstant), m_value(value) {}
    /// What it shows @p seconds later, with @p ppm around it all that time.
    double step(double ppm, double seconds);
    [[nodiscard]] double value() const { return m_value; }

private:
    double m_timeConstant, m_value;
};

/// Share of a breath's concentration at @p distance from the mouth.
[[nodiscard]] double plumeShare(const GasSettings& settings, double distance, bool inSight);

/// CO2 around a robot: breath of victims on top of the air's.
class GasSensor final : public Sensor {
public:
    GasSensor(const GasSettings& settings, const Noise& noise, Time start);

    void run(const World& world, int robot, std::vector<HardwareSample>& samples) override;
    bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;
    /// What is truly at @p position (arena's frame) [ppm].
    [[nodiscard]] double concentration(const World& world, int robot, const Eigen::Vector3d& position) const;

private:
    GasSettings m_settings;
    Noise m_noise;
    Schedule m_ticks, m_schedule;
    bool m_enabled = true;
    GasLag m_lag;
};

}  // namespace leitstand::simulation
