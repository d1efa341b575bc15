#pragma once

#include <cstdint>
#include <vector>

#include "core/base/pose.h"
#include "core/event/scan_links.h"

namespace leitstand {

/// A pose that links constrain.
struct GraphNode {
    std::uint64_t id = 0;
    Pose pose = Pose::Identity();  ///< in the map
    bool fixed = false;            ///< does not move
};

/// Poses, and what is known of their relative poses.
struct PoseGraph {
    std::vector<GraphNode> nodes;  ///< by rising id
    std::vector<Link> links;
};

}  // namespace leitstand
