#pragma once

#include "core/cloud/scan.h"
#include "core/mapping/registration_settings.h"

namespace leitstand {

/// @p scan with labels: itself where it has them, else a copy labelled by labelScan().
[[nodiscard]] ScanPtr labelled(const ScanPtr& scan);

/// The points of a labelled scan @p whole that take part in registration: within the range, filtered and
/// reduced as @p settings say, each with its label and normal. Before voxels are made, mixed pixels of
/// organised scans are left out, but for the paper's filter. Normals of organised scans come from the whole
/// grid, those of other scans from the neighbours among the points that are left.
[[nodiscard]] PointCloud prepared(const Scan& whole, const RegistrationSettings& settings);

}  // namespace leitstand
