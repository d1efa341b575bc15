#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/mapping/graph/pose_graph.h"

namespace leitstand {

/// Reads a graph of poses in the text format of g2o (Kuemmerle et al. 2011): lines "VERTEX_SE3:QUAT id x y z
/// qx qy qz qw", "EDGE_SE3:QUAT from to x y z qx qy qz qw" with the upper triangle of the information row by
/// row, and "FIX id"; blank lines and comments ('#') are left out. Ids are any whole numbers; nodes come by
/// rising id, links in the file's order. An edge between nodes that follow each other is odometry, any other
/// a loop. A quaternion is normalised; an error where it is nearly zero, where a node of an edge is not in
/// the file, and where an information is not positive semidefinite.
[[nodiscard]] Result<PoseGraph> readG2o(const std::filesystem::path& file);

/// Writes @p graph's nodes and active links so that readG2o() gives the same numbers.
[[nodiscard]] Result<void> writeG2o(const std::filesystem::path& file, const PoseGraph& graph);

}  // namespace leitstand
