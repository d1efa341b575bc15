#pragma once

#include <vector>

#include "core/mapping/live/robot_in_map.h"
#include "core/mapping/report_scan.h"

namespace leitstand {

struct KeyScanSample;

/// Converts the key scan @p sample for SearchBook.
[[nodiscard]] ReportScan scanOf(const KeyScanSample& sample);
/// Returns where base_link of @p robots was and is, in the map [m].
[[nodiscard]] std::vector<Eigen::Vector3d> trailsOf(const RobotsInMap& robots);

}  // namespace leitstand
