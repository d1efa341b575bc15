#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace leitstand::detail {

inline constexpr std::size_t BlockSize = 8;  ///< number of points in a block: one step of AVX2

/// Points of a leaf, axis by axis [m]. Unused places have +infinity, which is never the nearest.
struct alignas(32) KdBlock {
    std::array<float, BlockSize> x, y, z;
};

/// A reference to a node or a leaf, packed into one word so that the descent moves only one word. It is index
/// * 16 + number of blocks in the leaf (0 for a node).
class KdRef {
public:
    static constexpr std::uint32_t MostBlocks = 15;  ///< largest number of blocks in a leaf
    /// Largest number of nodes, or of blocks, in a tree.
    static constexpr std::uint32_t MostIndices = 1U << 28;

    KdRef() = default;
    KdRef(std::uint32_t first, std::uint32_t blocks) : packed(first << 4 | blocks) {}

    [[nodiscard]] bool isNode() const { return (packed & MostBlocks) == 0; }
    /// Index of the first node, or of a leaf's first block.
    [[nodiscard]] std::uint32_t first() const { return packed >> 4; }
    [[nodiscard]] std::uint32_t end() const {
        return (packed >> 4) + (packed & MostBlocks);
    }  ///< end of the leaf's blocks

    std::uint32_t packed;  // left unset by default: searches hold arrays of these
};

/// The smallest box around the points of a child [m]. The upper corner is stored negated.
struct KdBox {
    std::array<float, 3> low, negativeHigh;
};

/// An inner node with the boxes of both its children: one cache line has all that a step of the descent
/// needs. The descent visits child 1 first if the query's coordinate is not below the split.
struct alignas(64) KdNode {
    std::array<KdBox, 2> boxes;
    std::array<KdRef, 2> children;
    std::uint32_t axis;
    float split;  ///< [m]
};

/// A kd-tree over its own copy of the points. Nodes are in preorder, leaves in the order of the descent.
struct KdStorage {
    std::vector<KdNode> nodes;
    std::vector<KdBlock> blocks;
    std::vector<std::int32_t> indices;  ///< index of the point at each place in the blocks; -1: unused place
    KdRef root{};                       ///< not used in an empty tree
    std::size_t size = 0;               ///< number of points in the tree

    [[nodiscard]] bool empty() const { return size == 0; }
};

/// Result of a search: a place in the blocks. If nothing was found, place is None, and squaredDistance is the
/// initial bound of the search [m^2].
struct KdFound {
    static constexpr std::uint32_t None = 0xffffffff;
    std::uint32_t place = None;
    float squaredDistance = 0.0F;
};

/// Nodes at this depth are split in halves: then there are at most 32 more levels.
inline constexpr int MaxMeanDepth = 40;
inline constexpr int MaxDepth = MaxMeanDepth + 34;

/// Squared distance as every search computes it, so that the same points have the same distance in all of
/// them [m^2].
inline float squaredDistance(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
    const float dx = a.x() - b.x(), dy = a.y() - b.y(), dz = a.z() - b.z();
    return dx * dx + dy * dy + dz * dz;
}

}  // namespace leitstand::detail
