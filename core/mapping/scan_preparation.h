#pragma once

#include "core/cloud/scan.h"
#include "core/mapping/registration_settings.h"

namespace leitstand {

/// Returns @p scan with labels. If it has none, returns a copy labelled by labelScan().
[[nodiscard]] ScanPtr labelled(const ScanPtr& scan);

/// Returns the points of the labelled scan @p whole for registration, each with its label and normal. They
/// are limited in range, filtered and reduced as @p settings say. Mixed pixels of organised scans are removed
/// before voxels are made, except with the paper's filter. Normals of organised scans are computed from the
/// whole grid, those of other scans from neighbours among the remaining points. A plane laser's scan becomes
/// wallsAndFloor() on squares half as large, without labels.
[[nodiscard]] PointCloud prepared(const Scan& whole, const RegistrationSettings& settings);

}  // namespace leitstand
