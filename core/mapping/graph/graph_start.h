#pragma once

#include "core/mapping/graph/pose_graph.h"

namespace leitstand {

/// Moves the nodes of @p graph, by rising id, to where an active link puts them relative to a node of a lower
/// id. Of a node's links, one of the surest kind counts: matches, then the operator's, then odometry, then
/// loops. Of one kind, the link with the lowest id counts. Nodes that are fixed, or that have no such link,
/// stay. Parts may still be separate then although a link joins them. Of two such parts, the later one moves
/// as a whole to where its surest link puts it. So the start of a solver depends on the links alone, and not
/// on an earlier solution.
void startFromLinks(PoseGraph& graph);

}  // namespace leitstand
