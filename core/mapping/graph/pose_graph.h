#pragma once

#include <cstdint>
#include <vector>

#include "core/base/pose.h"
#include "core/event/scan_links.h"

namespace leitstand {

/// A pose that links constrain.
struct GraphNode {
    std::uint64_t id = 0;
    Pose pose = Pose::Identity();  ///< pose in the map
    bool fixed = false;            ///< whether the node keeps its pose
};

/// Poses, and links that say what is known of their relative poses.
struct PoseGraph {
    std::vector<GraphNode> nodes;  ///< by rising id
    std::vector<Link> links;
};

}  // namespace leitstand
