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
    /// not used any more.
    void restart(std::uint64_t lastLeftOut);

    /// Returns the direction against gravity by @p live, in the scan's frame, without the lean as far as that
    /// is known.
    [[nodiscard]] Eigen::Vector3d upOf(const LiveScan& live) const;
    /// Adds @p live, which fits as in @p match, to the estimate of the lean. @p before: pose in the map of
    /// the robot's scan before, from which it came @p way [m]; null: it did not come from there.
    void addLean(const LiveScan& live, const Match& match, const Pose* before, double way);
    /// Notes that @p live entered the map as in @p match.
    void enteredMap(const LiveScan& live, const Match& match);

    /// Adds @p live, registered to @p scanInMap, to the estimate of the mount. @p fits: surfaces and odometry
    /// both show the motion from the robot's newest scan, at @p before in the map.
    void addMount(const LiveScan& live, const Pose& scanInMap, const Pose& before, bool fits);

    /// Compares the ranges of @p entered, whose points for matching are @p cloud, with an earlier scan of @p
    /// map.
    void compare(const LiveKeyScan& entered, const PointCloud& cloud, const LiveMap& map);

    [[nodiscard]] ScannerCalibration calibration() const;

private:
    RangeBias m_rangeBias;
    ScannerLean m_lean;
    ScannerMount m_mount;
    Pose m_mountAt = Pose::Identity();  ///< the last scan of the mount's estimate, as it was then in the map
    Pose m_leanAt = Pose::Identity();   ///< the last scan of the lean's estimate, as it was then in the map
    std::uint64_t m_since = 0;          ///< id of a scan; only later ones are of the scanner as it is now
    std::size_t m_comparisons = 0;      ///< of key scans since, for RangeBias, whether they counted or not
    std::uint64_t m_compared = 0;       ///< id of the scan that key scans were compared with last ...
    int m_comparedAgain = 0;            ///< ... and how often in a row
};

}  // namespace leitstand
