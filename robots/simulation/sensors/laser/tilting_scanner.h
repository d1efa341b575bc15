#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/event/cloud_sample.h"
#include "robots/simulation/sensors/laser/laser_head.h"
#include "robots/simulation/sensors/sensor.h"

namespace leitstand::simulation {

/// Settings and mounting of the tilting scanner of 2004 (paper, figure 3, left).
struct TiltingScannerSettings {
    LaserSettings laser;
    int rows = 241;                ///< number of raw scans, half a degree apart
    int columns = 181;             ///< number of points in each, one degree apart, from left to right
    double highest = degrees(60);  ///< elevation of the first row [rad]
    /// Angles of a sweep to the sides and downwards [rad].
    double across = degrees(180), down = degrees(120);
    /// Time for one turn of the mirror.
    std::chrono::nanoseconds rawScan = std::chrono::microseconds(13'333);
    /// Time for which the robot must stand before a sweep begins.
    std::chrono::nanoseconds settle = std::chrono::milliseconds(300);
    std::chrono::nanoseconds back = std::chrono::milliseconds(800);  ///< time until the next sweep can begin
    std::string sensor, frame;
    Pose mountInBase = Pose::Identity();
};

/// A plane laser that is tilted by a servo: stop, scan, go. It sweeps again and again while the robot stands,
/// and sends each sweep when it is complete. If the robot moves during a sweep, it is discarded.
class TiltingScanner final : public Sensor {
public:
    TiltingScanner(const TiltingScannerSettings& settings, const Noise& noise, Time start);

    void run(const World& world, int robot, std::vector<HardwareSample>& samples) override;
    bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;
    /// Returns the direction of a shot in the frame of the mount, unit length.
    [[nodiscard]] static Eigen::Vector3d direction(const TiltingScannerSettings& settings, int row,
                                                   int column);

private:
    [[nodiscard]] std::chrono::nanoseconds shotAfter(int row, int column) const;
    void measureRow(const World& world, int robot);

    TiltingScannerSettings m_settings;
    LaserHead m_head;
    Time m_standingSince, m_start;  ///< m_start: when the next or present sweep begins
    bool m_enabled = true;
    CloudSample m_sweep;  ///< rows measured so far
    std::vector<Ray> m_rays;
};

}  // namespace leitstand::simulation
