#pragma once

#include "core/cloud/scan.h"
#include "core/mapping/registration_settings.h"

namespace leitstand {

/// Returns @p scan with labels: itself if it has them, else a copy labelled by labelScan().
[[nodiscard]] ScanPtr labelled(const ScanPtr& scan);

/// Returns the points of a labelled scan @p whole for registration: within the range, filtered and reduced by
/// @p settings, each with its label and normal. Mixed pixels of organised scans are left out before voxels
/// are made, except with the paper's filter. Normals of organised scans come from the whole grid, those of
/// other scans from the neighbours among the points that are left. A plane laser's scan becomes
/// wallsAndFloor() on squares half as large, without labels.
[[nodiscard]] PointCloud prepared(const Scan& whole, const RegistrationSettings& settings);

}  // namespace leitstand
