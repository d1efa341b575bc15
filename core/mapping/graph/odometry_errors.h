#pragma once

#include "core/mapping/graph/pose_graph.h"

namespace leitstand {

/// Corrects the odometry links of @p graph by the errors that matches show. Each chain of odometry links
/// belongs to one robot and is corrected separately. Nodes must have the poses from startFromLinks().
///
/// Systematic errors are estimated by least squares where surfaces hold the scans, and removed from all
/// links. Distances and turns are too long or too short by a share (worn wheels, a wrong diameter, tracks
/// that slide). The heading drifts with the distance (wheels of unequal size). The remaining error determines
/// the weight of the links.
void correctOdometry(PoseGraph& graph);

}  // namespace leitstand
