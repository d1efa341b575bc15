#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/event/cloud_sample.h"
#include "core/event/motion_samples.h"
#include "core/mapping/live/map/live_scan.h"
#include "core/mapping/motion/motion_buffer.h"
#include "core/mapping/motion/turn_assembler.h"

namespace leitstand {

/// When a scan is cut, and how long a slice waits.
struct ScanCutterSettings {
    std::chrono::nanoseconds longestWait = std::chrono::milliseconds(150);  ///< of a slice for odometry
    double longestWay = 1.5;           ///< of the scanner within a scan [m]
    double mostTurned = degrees(270);  ///< of the robot within a scan [rad]
};

/// Makes scans of what one 3D scanner of one robot sends, as it comes: each point moved by the robot's motion
/// since its own shot, a scan for each turn, or shorter where the robot moved too far; whole sweeps are scans
/// by themselves. A slice waits for odometry that covers its end, at most as long as the settings say, then
/// the motion is guessed from the last speed. Every slice gets into one scan: those that come late, after a
/// radio gap, too, in whatever order. Without clock and thread: the caller tells what time it is, on the
/// station's clock.
class ScanCutter {
public:
    explicit ScanCutter(std::string robot, const ScanCutterSettings& settings = {});

    void add(const OdometrySample& odometry, Time now);
    void add(const ImuSample& imu, const Pose& unitInBase, Time now);
    /// A sample without a stamp counts as taken @p now. Slices that came before (the same stamp and frame)
    /// are left out.
    void add(CloudSample slice, const Pose& sensorInBase, Time now);

    /// The scans that are complete @p now, by their ends' stamps unless they came late.
    [[nodiscard]] std::vector<LiveScan> take(Time now);
    /// When take() has something to do at the latest, without another sample; empty: nothing waits.
    [[nodiscard]] std::optional<Time> due() const;
    /// The stamps of slices to come are of another clock: what is gathered of a turn ends.
    void startAnew();
    /// All that is gathered, as scans, whole turns or not: the scanner was switched off, or the mission ends.
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
    /// What a scan is made of so far.
    struct Parts {
        int slices = 0;
        int poses = 0, guessed = 0;  ///< that were asked for, and those of them that are extrapolated
        bool bridged = false;
    };
    /// Slices that follow each other.
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
    void tellMotion(LiveScan& live, Time start, Time end) const;

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
