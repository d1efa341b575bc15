#pragma once

#include "core/mapping/graph/pose_graph.h"

namespace leitstand {

/// Corrects @p graph's odometry links by what matches show of their errors, apart for each chain of them,
/// which is a robot; nodes stand where startFromLinks() put them. What is systematic is estimated by least
/// squares over the runs of scans that surfaces hold, and taken out of all links: ways are too long or too
/// short by a share (worn wheels, a wrong diameter), turns likewise (tracks that slide), and the heading
/// drifts with the way (wheels of unequal size). What is left over tells how much the links are to weigh.
void correctOdometry(PoseGraph& graph);

}  // namespace leitstand
