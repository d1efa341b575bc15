#pragma once

#include <cstddef>
#include <filesystem>

#include "core/base/result.h"
#include "core/handin/map/voxel_evidence.h"

namespace leitstand {

/// What an OctoMap has.
struct OctomapSummary {
    double cell = 0.0;      ///< edge of the smallest cubes [m]
    double occupied = 0.0;  ///< volume [m3]
    double free = 0.0;      ///< volume [m3]
    std::size_t nodes = 0;  ///< of the tree
};

/// Writes @p evidence as an OctoMap's binary tree (.bt): cubes that are occupied, free or unknown, equal
/// neighbours joined. Equal evidence makes equal bytes.
[[nodiscard]] Result<void> writeOctomap(const std::filesystem::path& file, const VoxelEvidence& evidence);

/// Reads a .bt through OctoMap; an error names the file.
[[nodiscard]] Result<OctomapSummary> readOctomap(const std::filesystem::path& file);

}  // namespace leitstand
