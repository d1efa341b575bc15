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

/// What the map tells of a robot's scanner, from scan to scan.
class ScannerTrack {
public:
    /// The scanner is another one, or corrected: nothing is known of it. The key scan @p lastLeftOut, and
    /// those before, do not tell.
    void restart(std::uint64_t lastLeftOut);

    /// What @p live says is against gravity, in its frame, as far as the lean is known.
    [[nodiscard]] Eigen::Vector3d upOf(const LiveScan& live) const;
    /// @p live, which fits as @p match says after @p way [m], tells how the scanner leans. @p before: where
    /// the robot's newest scan lies in the map; null: it does not go on from there.
    void addLean(const LiveScan& live, const Match& match, const Pose* before, double way);
    /// @p live entered the map as @p match says.
    void enteredMap(const LiveScan& live, const Match& match);

    /// @p live, which came to lie at @p scanInMap, tells how the scanner sits, where @p fits: odometry and
    /// surfaces tell how the robot came there from its newest scan, which lies at @p before in the map.
    void addMount(const LiveScan& live, const Pose& scanInMap, const Pose& before, bool fits);

    /// What @p entered, of which @p cloud is matched, tells of ranges beside an earlier scan of @p map.
    void compare(const LiveKeyScan& entered, const PointCloud& cloud, const LiveMap& map);

    [[nodiscard]] ScannerCalibration calibration() const;

private:
    RangeBias m_rangeBias;
    ScannerLean m_lean;
    ScannerMount m_mount;
    Pose m_mountAt = Pose::Identity();  ///< the scan that told of the mount last, as it was then in the map
    Pose m_leanAt = Pose::Identity();   ///< likewise of the lean
    std::uint64_t m_since = 0;          ///< the scanner is as it is now from the scan after this id on
    std::size_t m_comparisons = 0;      ///< of key scans since, for RangeBias, whether they told or not
    std::uint64_t m_compared = 0;       ///< id of the scan that key scans were compared with last ...
    int m_comparedAgain = 0;            ///< ... and how often it was
};

}  // namespace leitstand
