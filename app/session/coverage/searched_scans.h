#pragma once

#include <vector>

#include "core/mapping/live/robot_in_map.h"
#include "core/mission/report/report_scan.h"
#include "core/robot/samples/map_samples.h"

namespace leitstand {

/// A key scan as SearchBook takes it.
[[nodiscard]] ReportScan scanOf(const KeyScanSample& sample);
/// base_link where @p robots were and are, in the map [m].
[[nodiscard]] std::vector<Eigen::Vector3d> trailsOf(const RobotsInMap& robots);

}  // namespace leitstand
