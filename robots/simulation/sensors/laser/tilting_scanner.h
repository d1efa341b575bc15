#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robots/simulation/sensors/laser/laser_head.h"
#include "robots/simulation/sensors/sensor.h"

namespace leitstand::simulation {

/// What the tilting scanner of 2004 is and where it sits (paper, figure 3, left).
struct TiltingScannerSettings {
    LaserSettings laser;
    int rows = 241;                ///< raw scans across, of half a degree from one to the next
    int columns = 181;             ///< points in each, of a degree, from the left to the right
    double highest = degrees(60);  ///< elevation of the first row [rad]
    double across = degrees(180), down = degrees(120);                     ///< [rad]
    std::chrono::nanoseconds rawScan = std::chrono::microseconds(13'333);  ///< a turn of the mirror
    std::chrono::nanoseconds settle = std::chrono::milliseconds(300);      ///< standing, before it begins
    std::chrono::nanoseconds back = std::chrono::milliseconds(800);        ///< until it can begin again
    std::string sensor, frame;
    Pose mountInBase = Pose::Identity();
};

/// A plane laser that a servo tilts: stop, scan, go. It sweeps while the robot stands, again and again, and
/// sends each whole sweep when it is done; a sweep in which the robot moves is thrown away.
class TiltingScanner final : public Sensor {
public:
    TiltingScanner(const TiltingScannerSettings& settings, const Noise& noise, Time start);

    void run(const World& world, int robot, std::vector<HardwareSample>& samples) override;
    bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;
    /// In the frame of the mount, unit length.
    [[nodiscard]] static Eigen::Vector3d direction(const TiltingScannerSettings& settings, int row,
                                                   int column);

private:
    [[nodiscard]] std::chrono::nanoseconds shotAfter(int row, int column) const;
    void measureRow(const World& world, int robot);

    TiltingScannerSettings m_settings;
    LaserHead m_head;
    Time m_standingSince, m_start;  ///< m_start: of the next or running sweep
    bool m_enabled = true;
    CloudSample m_sweep;  ///< rows so far
    std::vector<Ray> m_rays;
};

}  // namespace leitstand::simulation
