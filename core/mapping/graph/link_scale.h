#pragma once

#include "core/mapping/graph/pose_graph.h"

namespace leitstand {

/// Multiplies the ways of @p graph's odometry links by what matches show them to be; nodes stand where
/// startFromLinks() put them. Worn wheels and a wrong diameter make all ways too long or too short by the
/// same share, which shows where surfaces hold a scan along its way. Estimated by least squares over the runs
/// of such scans, apart for each chain of odometry links, which is a robot.
void scaleOdometry(PoseGraph& graph);

}  // namespace leitstand
