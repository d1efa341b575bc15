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
    std::chrono::nanoseconds longestWait = std::chrono::milliseconds(150);  ///< of a slice, for odometry
    double longestWay = 1.5;           ///< longest way of the scanner within a scan [m]
    double mostTurned = degrees(270);  ///< largest turn of the robot within a scan [rad]
};

/// Cuts scans from the slices of one 3D scanner of one robot, as they arrive. Each point is moved by the
/// robot's motion since its own shot. A scan is a turn, or less where the robot moved too far; whole sweeps
/// are scans of their own. A slice waits for odometry that covers its end, at most as long as the settings
/// allow. Then the motion is extrapolated from the last speed. Every slice enters one scan. Slices may come
/// late after a radio gap, and in any order. Without clock and thread: the caller passes the time of the
/// station's clock.
class ScanCutter {
public:
    explicit ScanCutter(std::string robot, const ScanCutterSettings& settings = {});

    void add(const OdometrySample& odometry, Time now);
    void add(const ImuSample& imu, const Pose& unitInBase, Time now);
    /// A sample without a stamp counts as taken @p now. Slices that were received before (the same stamp and
    /// frame) are left out.
    void add(CloudSample slice, const Pose& sensorInBase, Time now);

    /// Returns the scans that are complete @p now, in the order of their ends; scans of late slices may come
    /// out of order.
    [[nodiscard]] std::vector<LiveScan> take(Time now);
    /// Returns when take() has something to do at the latest, without another sample; empty: nothing waits.
    [[nodiscard]] std::optional<Time> due() const;
    /// Ends the current turn, since the stamps of later slices are of another clock.
    void restart();
    /// Returns scans of all slices gathered so far, whole turns or not: the scanner was switched off, or the
    /// mission ends.
    [[nodiscard]] std::vector<LiveScan> finish();

    [[nodiscard]] const MotionBuffer& motion() const { return m_motion; }
    [[nodiscard]] std::uint64_t doubled() const { return m_doubled; }  ///< slices that came twice

private:
    struct Waiting {
        CloudSample slice;
        Pose sensorInBase;
        Time arrived;
        std::uint64_t odometry;  ///< number of odometry samples before it came
    };
    /// What a scan consists of so far.
    struct Parts {
        int slices = 0;
        int poses = 0, guessed = 0;  ///< requested poses, and how many of them are extrapolated
        bool bridged = false;
    };
    /// Consecutive slices.
    struct Row {
        TurnAssembler assembler;
        Pose sensorInBase = Pose::Identity();
        std::optional<Time> end;  ///< of the newest slice, robot's clock
        Time arrived{};           ///< of the newest slice, station's clock
        int frame = 0;
        Parts parts;  ///< of what the assembler gathers
    };
    [[nodiscard]] bool ready(const Waiting& waiting, Time now) const;
    void put(Waiting waiting, Row& row);
    void close(Row& row);
    void keep(std::optional<Scan> scan, const Row& row, const Parts& parts);
    void publishMotion(LiveScan& live, Time start, Time end) const;

    std::string m_robot;
    ScanCutterSettings m_settings;
    MotionBuffer m_motion;
    std::multimap<Time, Waiting> m_waiting;    ///< by the slice's stamp
    std::multimap<Time, std::string> m_known;  ///< stamps and frames of the slices of the last minutes
    Row m_row, m_late;
    std::vector<LiveScan> m_done;
    std::optional<Time> m_lastEnd;  ///< of the newest scan
    std::uint64_t m_odometry = 0, m_doubled = 0;
    int m_clockJumps = 0;
};

}  // namespace leitstand
