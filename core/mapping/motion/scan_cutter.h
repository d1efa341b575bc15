#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/event/cloud_sample.h"
#include "core/mapping/live/map/live_scan.h"
#include "core/mapping/motion/motion_buffer.h"
#include "core/mapping/motion/turn_assembler.h"

namespace leitstand {

struct ImuSample;
struct OdometrySample;

/// Settings of ScanCutter: when a scan is cut, and how long a slice waits.
struct ScanCutterSettings {
    /// Longest time that a slice waits for odometry.
    std::chrono::nanoseconds longestWait = std::chrono::milliseconds(150);
    double longestWay = 1.5;           ///< largest distance that the scanner moves within a scan [m]
    double mostTurned = degrees(270);  ///< largest turn of the robot within a scan [rad]
};

/// Cuts the slices of one 3D scanner into scans, as they arrive. Each point is moved by the robot's motion
/// since its own shot. A scan is a turn, or less if the robot moved too far; a slice that is a whole sweep is
/// a scan by itself. A slice waits for odometry up to its end, but only as long as the settings allow. Then
/// the motion is extrapolated from the last speed. Every slice enters exactly one scan. Slices may arrive
/// late after a gap of the radio, and in any order. It has no clock and no thread: the caller passes the time
/// of the station's clock.
class ScanCutter {
public:
    explicit ScanCutter(std::string robot, const ScanCutterSettings& settings = {});

    void add(const OdometrySample& odometry, Time now);
    void add(const ImuSample& imu, const Pose& unitInBase, Time now);
    /// A slice without a stamp counts as taken @p now. A slice that was received before (same stamp and
    /// frame) is ignored.
    void add(CloudSample slice, const Pose& sensorInBase, Time now);

    /// Returns the scans that are complete @p now, in the order of their ends. Scans of late slices may be
    /// out of order.
    [[nodiscard]] std::vector<LiveScan> take(Time now);
    /// Returns when take() must be called at the latest, even without another sample; empty: nothing waits.
    [[nodiscard]] std::optional<Time> due() const;
    /// Ends the current turn, because the stamps of later slices come from another clock.
    void restart();
    /// Returns scans of all slices so far, even if turns are incomplete. Call when the scanner is switched
    /// off or the mission ends.
    [[nodiscard]] std::vector<LiveScan> finish();

    [[nodiscard]] const MotionBuffer& motion() const { return m_motion; }
    /// Number of slices that were received twice.
    [[nodiscard]] std::uint64_t doubled() const { return m_doubled; }

private:
    struct Waiting {
        CloudSample slice;
        Pose sensorInBase;
        Time arrived;
        std::uint64_t odometry;  ///< number of odometry samples received before the slice
    };
    /// What a scan consists of so far.
    struct Parts {
        int slices = 0;
        int poses = 0, guessed = 0;  ///< number of poses used, and how many of them are extrapolated
        bool bridged = false;
    };
    /// Slices that follow each other.
    struct Row {
        TurnAssembler assembler;
        Pose sensorInBase = Pose::Identity();
        std::optional<Time> end;  ///< end of the newest slice, robot's clock
        Time arrived{};           ///< when the newest slice arrived, station's clock
        int frame = 0;
        Parts parts;  ///< odometry and parts of the slices in the assembler
    };
    [[nodiscard]] bool ready(const Waiting& waiting, Time now) const;
    void put(Waiting waiting, Row& row);
    void close(Row& row);
    void keep(std::optional<Scan> scan, const Row& row, const Parts& parts);
    void publishMotion(LiveScan& live, Time start, Time end) const;

    std::string m_robot;
    ScanCutterSettings m_settings;
    MotionBuffer m_motion;
    std::multimap<Time, Waiting> m_waiting;    ///< by stamp of the slice
    std::multimap<Time, std::string> m_known;  ///< stamps and frames of slices in the last minutes
    Row m_row, m_late;
    std::vector<LiveScan> m_done;
    std::optional<Time> m_lastEnd;  ///< end of the newest scan
    std::uint64_t m_odometry = 0, m_doubled = 0;
    int m_clockJumps = 0;
};

}  // namespace leitstand
