#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "core/event/motion_samples.h"
#include "core/mapping/motion/scan_cutter.h"

namespace leitstand::test {

/// A turning scanner of 45 raw scans of 12 points a turn, a slice of 3 of them every 0.1 s (a turn in 1.5 s),
/// in the middle of a cylinder of 3 m radius; every raw scan has a number of its own in its intensities.
struct SliceMaker {
    static constexpr int Rows = 3, Columns = 12, RowsATurn = 45;
    static constexpr int SlicesATurn = RowsATurn / Rows;
    static constexpr std::chrono::milliseconds Slice{100};

    Time start = Time(std::chrono::seconds(1000));
    int firstRow = 0;  ///< where in its turn it begins
    int made = 0;      ///< slices

    [[nodiscard]] Time stampOf(int slice) const { return start + slice * Slice; }
    [[nodiscard]] CloudSample slice(int number) const;
    /// Slices [first, last).
    [[nodiscard]] std::vector<CloudSample> slices(int first, int last) const;
};

/// Odometry at @p stamp.
[[nodiscard]] OdometrySample odometryAt(Time stamp, const Pose& baseInOdom);

/// Numbers of the raw scans in @p scans, sorted: what got into them, and how often.
[[nodiscard]] std::vector<int> rowsIn(const std::vector<LiveScan>& scans);
/// 0 ... @p count - 1
[[nodiscard]] std::vector<int> allRows(int count);

/// The world's time runs; odometry of a robot at a steady speed comes 20 times a second.
class Operation {
public:
    explicit Operation(ScanCutter& made, Time begin = Time(std::chrono::seconds(1000)))
        : cutter(made), now(begin), m_next(begin) {}
    /// Passes time in steps of 10 ms.
    void until(Time end);
    void give(CloudSample slice) { cutter.add(std::move(slice), Pose::Identity(), now); }
    [[nodiscard]] Pose poseAt(Time stamp) const;

    ScanCutter& cutter;
    std::vector<LiveScan> scans;
    Time now;                               ///< station's clock; the robot's is ahead of it
    std::chrono::nanoseconds robotAhead{};  ///< of the robot's clock
    bool odometry = true;
    double speed = 0.0, turnRate = 0.0;  ///< [m/s, rad/s]

private:
    Time m_next;
};

}  // namespace leitstand::test
