#pragma once

#include "core/mapping/graph/pose_graph.h"

namespace leitstand {

/// Moves each node of @p graph to where one active link leads to it from a node of a lower id, in the order
/// of ids. The surest kind of link is used (matches, then the operator's, then odometry, then loops), and
/// among these the one with the lowest id. Nodes that are fixed, or that no link leads to, stay. A part that
/// is separate after this, but linked, follows its surest link to the part that stays. So the start of a
/// solver depends on the links alone, and not on an earlier solution.
void startFromLinks(PoseGraph& graph);

}  // namespace leitstand
