#pragma once

#include "core/mapping/graph/pose_graph.h"

namespace leitstand {

/// Puts each node of @p graph to where one link leads to it from a node of a lower id, in that order: of its
/// active links to lower nodes the surest kind (matches, then the operator's, then odometry, then loops), and
/// of those the one of the lowest id. What no link leads to, and what is fixed, stays; what came to lie apart
/// so and is linked nevertheless goes along with its surest link to what stays. So where a solver
/// begins depends on the links alone, and not on what was solved before.
void startFromLinks(PoseGraph& graph);

}  // namespace leitstand
