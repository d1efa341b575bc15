#pragma once

#include <cstdint>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/cloud/scan.h"

namespace leitstand {

/// A key scan of a mission, with its present pose.
struct ReportScan {
    std::uint64_t id = 0;                  ///< KeyScanSample::id; 0: from a bag without key scans
    ScanPtr scan;                          ///< never null
    Pose scanInMap = Pose::Identity();     ///< newest pose
    Pose sensorInBase = Pose::Identity();  ///< pose at the end of the sweep

    [[nodiscard]] Pose baseInMap() const { return scanInMap * sensorInBase.inverse(); }
};

}  // namespace leitstand
