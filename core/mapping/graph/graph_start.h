#pragma once

#include "core/mapping/graph/pose_graph.h"

namespace leitstand {

/// Gives the nodes of @p graph poses from which a solver can start. In the order of their ids, each node is
/// placed relative to a node with a lower id, by an active link. If there are several links, the kind
/// decides: matches first, then the operator's, then odometry, then loops. Of several links of this kind, the
/// one with the lowest id is used. Nodes that are fixed, or that have no such link, stay.
///
/// Afterwards two parts may still be apart although a link connects them. Then the later part is moved as a
/// whole to where its surest link puts it. So the start depends only on the links, and not on an earlier
/// solution.
void startFromLinks(PoseGraph& graph);

}  // namespace leitstand
