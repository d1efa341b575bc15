#pragma once

#include <vector>

#include "core/scan/scan.h"

namespace leitstand {

/// Settings of the semantic labels (paper, section 2.2).
struct LabelSettings {
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< against gravity, in the scan's frame
};

/// Labels of all points of @p scan: one a point, Unlabelled where there is no echo or nothing decides.
[[nodiscard]] std::vector<Label> labelScan(const Scan& scan, const LabelSettings& settings = {});

}  // namespace leitstand
