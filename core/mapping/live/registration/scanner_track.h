#pragma once

#include <cstddef>
#include <cstdint>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/mapping/calibration/range_bias.h"
#include "core/mapping/calibration/scanner_calibration.h"
#include "core/mapping/calibration/scanner_lean.h"
#include "core/mapping/calibration/scanner_mount.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/map/live_scan.h"
#include "core/mapping/live/scan_work.h"

namespace leitstand {

/// What the map shows of a robot's scanner, from scan to scan.
class ScannerTrack {
public:
    /// Forgets everything: the scanner was replaced or corrected. Key scans up to the id @p lastLeftOut are
    /// no longer used.
    void restart(std::uint64_t lastLeftOut);

    /// Returns the upward direction that @p live measured, in the scan's frame, corrected by the lean that is
    /// known so far.
    [[nodiscard]] Eigen::Vector3d upOf(const LiveScan& live) const;
    /// Adds @p live, which was matched as in @p match, to the estimate of the lean. @p before: pose in the
    /// map of the robot's previous scan, from which it drove @p way [m]. Null: it did not drive from there.
    void addLean(const LiveScan& live, const Match& match, const Pose* before, double way);
    /// Notes that @p live entered the map at the pose of @p match.
    void enteredMap(const LiveScan& live, const Match& match);

    /// Adds @p live, registered to @p scanInMap, to the estimate of the mount. @p before: pose of the robot's
    /// previous scan in the map. @p fits: whether surfaces and odometry both show the motion from there.
    void addMount(const LiveScan& live, const Pose& scanInMap, const Pose& before, bool fits);

    /// Compares the ranges of @p entered with those of an earlier scan of @p map. @p cloud: points of
    /// @p entered for matching.
    void compare(const LiveKeyScan& entered, const PointCloud& cloud, const LiveMap& map);

    [[nodiscard]] ScannerCalibration calibration() const;

private:
    RangeBias m_rangeBias;
    ScannerLean m_lean;
    ScannerMount m_mount;
    /// Pose in the map of the last scan used for the mount, when it was added.
    Pose m_mountAt = Pose::Identity();
    /// Pose in the map of the last scan used for the lean, when it was added.
    Pose m_leanAt = Pose::Identity();
    std::uint64_t m_since = 0;  ///< id of a scan; only later scans show the present scanner
    /// How many key scans since then were compared for RangeBias, successfully or not.
    std::size_t m_comparisons = 0;
    std::uint64_t m_compared = 0;  ///< id of the earlier scan that was last used for comparison ...
    int m_comparedAgain = 0;       ///< ... and how many times in a row
};

}  // namespace leitstand
