#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/mapping/graph/pose_graph.h"

namespace leitstand {

/// Reads a graph of poses in the text format of g2o (Kuemmerle et al. 2011). Lines are "VERTEX_SE3:QUAT id x
/// y z qx qy qz qw", "EDGE_SE3:QUAT from to x y z qx qy qz qw" and "FIX id". An edge ends with the upper
/// triangle of its information matrix, row by row. Blank lines and comments ('#') are skipped.
///
/// Ids are any whole numbers; nodes are sorted by id, links keep the order of the file. An edge between
/// consecutive ids is odometry, any other edge is a loop. Quaternions are normalised. Error when a quaternion
/// is nearly zero, when a node of an edge is missing, or when an information matrix is not positive
/// semidefinite.
[[nodiscard]] Result<PoseGraph> readG2o(const std::filesystem::path& file);

/// Writes the nodes and active links of @p graph so that readG2o() returns the same numbers.
[[nodiscard]] Result<void> writeG2o(const std::filesystem::path& file, const PoseGraph& graph);

}  // namespace leitstand
