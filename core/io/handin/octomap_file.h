#pragma once

#include <cstddef>
#include <filesystem>

#include "core/base/result.h"
#include "core/handin/map/voxel_evidence.h"

namespace leitstand {

/// Size and contents of an OctoMap.
struct OctomapSummary {
    double cell = 0.0;      ///< edge of the smallest cubes [m]
    double occupied = 0.0;  ///< volume [m3]
    double free = 0.0;      ///< volume [m3]
    std::size_t nodes = 0;  ///< number of nodes of the tree
};

/// Writes @p evidence as the binary tree of an OctoMap (.bt). Each cube is occupied, free or unknown, and
/// equal neighbours are merged. Equal evidence gives equal bytes.
[[nodiscard]] Result<void> writeOctomap(const std::filesystem::path& file, const VoxelEvidence& evidence);

/// Reads a .bt through OctoMap. Errors name the file.
[[nodiscard]] Result<OctomapSummary> readOctomap(const std::filesystem::path& file);

}  // namespace leitstand
