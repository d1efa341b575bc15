#pragma once

#include <string>
#include <vector>

#include "robots/simulation/sensors/noise.h"
#include "robots/simulation/sensors/schedule.h"
#include "robots/simulation/sensors/sensor.h"

namespace leitstand::simulation {

/// Settings for the CO2 in the air and for its sensor.
struct GasSettings {
    double rate = 1.0;            ///< default and highest rate [Hz]
    double base = 400.0;          ///< CO2 in the air [ppm]
    double plumeRadius = 0.4;     ///< distance at which the concentration of a breath is halved [m]
    double plumeReach = 4.0;      ///< a breath is not measured farther away than this [m]
    double aroundCorners = 0.15;  ///< share that arrives if there is no line of sight to the mouth
    double lag = 10.0;            ///< time constant of the sensor [s]
    double noise = 8.0;           ///< noise, standard deviation [ppm]
    double noiseOfValue = 0.01;   ///< additional noise, as a share of the value
    std::string sensor, frame;
    Pose sensorInBase = Pose::Identity();
};

/// First-order lag of a sensor that follows its input slowly.
class GasLag {
public:
    explicit GasLag(double timeConstant, double value) : m_timeConstant(timeConstant), m_value(value) {}
    /// Returns the measured value after @p seconds in air with @p ppm. The next step continues from there.
    double step(double ppm, double seconds);
    [[nodiscard]] double value() const { return m_value; }

private:
    double m_timeConstant, m_value;
};

/// Returns the share of a breath's concentration that remains at @p distance from the mouth [m].
[[nodiscard]] double plumeShare(const GasSettings& settings, double distance, bool inSight);

/// Measures CO2 around a robot: the CO2 in the air plus the breath of victims.
class GasSensor final : public Sensor {
public:
    GasSensor(const GasSettings& settings, const Noise& noise, Time start);

    void run(const World& world, int robot, std::vector<HardwareSample>& samples) override;
    bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;
    /// Returns the true concentration at @p position (arena's frame) [ppm].
    [[nodiscard]] double concentration(const World& world, int robot, const Eigen::Vector3d& position) const;

private:
    GasSettings m_settings;
    Noise m_noise;
    Schedule m_ticks, m_schedule;
    bool m_enabled = true;
    GasLag m_lag;
};

}  // namespace leitstand::simulation
