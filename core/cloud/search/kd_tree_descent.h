#pragma once

#include <algorithm>
#include <array>

#include <Eigen/Core>

#include "core/cloud/search/kd_tree_layout.h"

namespace leitstand::detail {

/// A subtree that waits to be searched.
struct KdWaiting {
    KdRef ref;
    float squaredDistance;  ///< squared distance of its box from the query [m^2]
};

/// Squared distance of @p query from @p box [m^2]. It is never above that of any point inside, even after
/// rounding: low - q <= p - q holds, and squares are added in the order of squaredDistance().
inline float boxDistance(const KdBox& box, const Eigen::Vector3f& query) {
    float result = 0.0F;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float q = query[static_cast<Eigen::Index>(axis)];
        const float outside = std::max(std::max(box.low[axis] - q, box.negativeHigh[axis] + q), 0.0F);
        result += outside * outside;
    }
    return result;
}

/// Squared distances of @p query from the points of @p block [m^2].
inline std::array<float, BlockSize> blockDistances(const KdBlock& block, const Eigen::Vector3f& query) {
    std::array<float, BlockSize> result;
    for (std::size_t i = 0; i < BlockSize; ++i) {
        const float dx = query.x() - block.x[i], dy = query.y() - block.y[i], dz = query.z() - block.z[i];
        result[i] = dx * dx + dy * dy + dz * dz;
    }
    return result;
}

/// Calls @p leaf(ref) for the leaf of @p query, and for all leaves whose squared distance is below @p bound
/// [m^2]. Of two children, the one on the query's side of the split comes first. Reads @p bound again after
/// each call. The search for AVX2 visits the same leaves in the same order.
template <class Leaf>
void descend(const KdStorage& tree, const Eigen::Vector3f& query, const float& bound, Leaf leaf) {
    if (tree.empty()) return;
    std::array<KdWaiting, MaxDepth> waiting;
    std::size_t count = 0;
    KdRef ref = tree.root;
    for (;;) {
        while (ref.isNode()) {
            const KdNode& node = tree.nodes[ref.first()];
            const std::size_t nearer = query[static_cast<Eigen::Index>(node.axis)] >= node.split ? 1 : 0;
            const float distance = boxDistance(node.boxes[1 - nearer], query);
            if (distance < bound) waiting[count++] = {node.children[1 - nearer], distance};
            ref = node.children[nearer];
        }
        leaf(ref);
        do {
            if (count == 0) return;
            --count;
        } while (!(waiting[count].squaredDistance < bound));
        ref = waiting[count].ref;
    }
}

}  // namespace leitstand::detail
