#pragma once

#include <string>
#include <vector>

#include "core/event/cloud_sample.h"
#include "robots/simulation/sensors/laser/laser_head.h"
#include "robots/simulation/sensors/laser/turning_pattern.h"
#include "robots/simulation/sensors/sensor.h"

namespace leitstand::simulation {

/// Settings and mounting of a turning scanner.
struct TurningScannerSettings {
    TurningPattern pattern;
    LaserSettings laser;
    std::string sensor;  ///< key of the sensor of its points, in the robot's description
    std::string frame;   ///< frame of the mount, which does not turn
    Pose mountInBase = Pose::Identity();
    std::string rangesSensor;  ///< key of the sensor of its raw scans as RangesSample
    std::string fanFrame;      ///< turning frame of its raw scans; empty: they are not sent
};

/// RTS/ScanDrive of Kurt3D: raw scans of 161 points from -70 to 90 degrees in steps of 1 degree. A turn takes
/// 2.3 s, 2 degrees per raw scan.
[[nodiscard]] TurningScannerSettings scanDrive();
/// Hokuyo URG upright on a turning unit: raw scans of 445 points in steps of 0.36 degrees. A turn takes 6 s,
/// 6 degrees per raw scan.
[[nodiscard]] TurningScannerSettings turningUrg();

/// A plane laser that turns continuously about the vertical axis. It sends slices of its turn in the frame of
/// its mount; each shot is measured from the robot's pose at that moment. The raw scan that begins a turn
/// also completes the previous turn: it is measured once and sent in both.
class TurningScanner final : public Sensor {
public:
    TurningScanner(const TurningScannerSettings& settings, const Noise& noise, Time start);

    void run(const World& world, int robot, std::vector<HardwareSample>& samples) override;
    bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;

private:
    void aim(const World& world, int robot);
    void append(std::span<const LaserEcho> echoes, int ring, CloudSample& slice) const;
    [[nodiscard]] bool isThinned() const { return m_enabled && m_every > 1; }
    void publishFan(std::span<const LaserEcho> echoes, std::vector<HardwareSample>& samples);
    void emitSlice(CloudSample& slice, Reach reach, std::vector<HardwareSample>& samples) const;
    [[nodiscard]] Time startOf(std::int64_t rawScan) const {
        return m_start + m_settings.pattern.startOf(rawScan);
    }

    TurningScannerSettings m_settings;
    LaserHead m_head;
    Time m_start;
    std::int64_t m_rawScan = 0;  ///< number of the next one
    bool m_enabled = true, m_rangesEnabled = true;
    int m_every = 1;      ///< sends one of this many raw scans, and joins this many slices to one
    CloudSample m_slice;  ///< slice that is being filled, with all raw scans
    /// Slice that is being filled, only with raw scans that are sent in a thinned stream.
    CloudSample m_sent;
    std::vector<Ray> m_rays;
};

}  // namespace leitstand::simulation
