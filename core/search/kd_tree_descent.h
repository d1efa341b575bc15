#pragma once

#include <algorithm>
#include <array>

#include <Eigen/Core>

#include "core/search/kd_tree_layout.h"

namespace leitstand::detail {

/// A subtree that waits to be searched.
struct KdWaiting {
    KdRef ref;
    float squaredDistance;  ///< of its box [m^2]
};

/// Squared distance of @p query from @p box, never above those of the points inside: low - q <= p - q also
/// after rounding, and so are squares and sums taken in squaredDistance()'s order [m^2].
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

/// Calls @p leaf(ref) for the leaves that are nearer to @p query than @p bound, nearer ones first; the bound
/// is read anew after each [m^2].
template <class Leaf>
void descend(const KdStorage& tree, const Eigen::Vector3f& query, const float& bound, Leaf leaf) {
    if (tree.empty()) return;
    std::array<KdWaiting, MaxDepth> waiting;
    std::size_t count = 0;
    waiting[count++] = {tree.root, 0.0F};
    while (count > 0) {
        KdWaiting next = waiting[--count];
        while (next.squaredDistance < bound) {
            if (!next.ref.isNode()) {
                leaf(next.ref);
                break;
            }
            const KdNode& node = tree.nodes[next.ref.first()];
            const std::size_t nearer = query[static_cast<Eigen::Index>(node.axis)] < node.split ? 0 : 1;
            waiting[count++] = {node.children[1 - nearer], boxDistance(node.boxes[1 - nearer], query)};
            next = {node.children[nearer], boxDistance(node.boxes[nearer], query)};
        }
    }
}

}  // namespace leitstand::detail
