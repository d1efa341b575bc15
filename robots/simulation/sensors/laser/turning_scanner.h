#pragma once

#include <string>
#include <vector>

#include "robots/simulation/sensors/laser/laser_head.h"
#include "robots/simulation/sensors/laser/turning_pattern.h"
#include "robots/simulation/sensors/sensor.h"

namespace leitstand::simulation {

/// What a turning scanner is and where it sits.
struct TurningScannerSettings {
    TurningPattern pattern;
    LaserSettings laser;
    std::string sensor;  ///< key of the description, of its points
    std::string frame;   ///< of the mount, which does not turn
    Pose mountInBase = Pose::Identity();
    std::string rangesSensor;  ///< of its raw scans as RangesSample
    std::string fanFrame;      ///< that turns, of raw scans; empty: they are not told
};

/// RTS/ScanDrive of Kurt3D: 161 points of 1 degree from -70 to 90 degrees, a turn of 2 degrees each in 2.3 s.
[[nodiscard]] TurningScannerSettings scanDrive();
/// Hokuyo URG upright on a unit that turns: 445 points of 0.36 degrees, a turn of 6 degrees each in 6 s.
[[nodiscard]] TurningScannerSettings turningUrg();

/// A plane laser that turns about the vertical axis without end, and sends slices of its turn in the frame of
/// its mount, in which each shot is measured from where the robot is at that moment. The raw scan with which
/// a turn begins closes the turn before as well: one measurement that is sent in both.
class TurningScanner final : public Sensor {
public:
    TurningScanner(const TurningScannerSettings& settings, const Noise& noise, Time start);

    void run(const World& world, int robot, std::vector<HardwareSample>& samples) override;
    bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;

private:
    void aim(const World& world, int robot);
    void append(std::span<const LaserEcho> echoes, int ring, CloudSample& slice) const;
    [[nodiscard]] bool isThinned() const { return m_enabled && m_every > 1; }
    void tellFan(std::span<const LaserEcho> echoes, std::vector<HardwareSample>& samples);
    void emitSlice(CloudSample& slice, Reach reach, std::vector<HardwareSample>& samples) const;
    [[nodiscard]] Time startOf(std::int64_t rawScan) const {
        return m_start + m_settings.pattern.startOf(rawScan);
    }

    TurningScannerSettings m_settings;
    LaserHead m_head;
    Time m_start;
    std::int64_t m_rawScan = 0;  ///< next one
    bool m_enabled = true, m_rangesEnabled = true;
    int m_every = 1;      ///< of so many raw scans one is sent, and so many slices as one
    CloudSample m_slice;  ///< being filled, of all raw scans
    CloudSample m_sent;   ///< likewise, of those that are sent where not all are
    std::vector<Ray> m_rays;
};

}  // namespace leitstand::simulation
