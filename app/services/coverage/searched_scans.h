#pragma once

#include <vector>

#include "core/event/map_samples.h"
#include "core/mapping/live/robot_in_map.h"
#include "core/mapping/report_scan.h"

namespace leitstand {

/// A key scan as SearchBook takes it.
[[nodiscard]] ReportScan scanOf(const KeyScanSample& sample);
/// Returns where base_link of @p robots was and is, in the map [m].
[[nodiscard]] std::vector<Eigen::Vector3d> trailsOf(const RobotsInMap& robots);

}  // namespace leitstand
