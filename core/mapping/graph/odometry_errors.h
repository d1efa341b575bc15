#pragma once

#include "core/mapping/graph/pose_graph.h"

namespace leitstand {

/// Corrects the odometry links of @p graph by the errors that matches show. Each chain of odometry links,
/// which is a robot, is corrected separately. Nodes must be where startFromLinks() put them. Systematic
/// errors are estimated by least squares over the runs of scans that surfaces hold, and removed from all
/// links. Distances are too long or too short by a share (worn wheels, a wrong diameter), and so are turns
/// (tracks that slide). The heading drifts with the distance (wheels of unequal size). The remaining error
/// sets the weight of the links.
void correctOdometry(PoseGraph& graph);

}  // namespace leitstand
