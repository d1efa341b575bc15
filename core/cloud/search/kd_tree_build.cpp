#include "core/cloud/search/kd_tree_build.h"

#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace leitstand::detail {
namespace {

constexpr std::size_t LeafSize = 96;  // points: blocks cost less than the steps that would split them
static_assert(LeafSize <= KdRef::MostBlocks * BlockSize);
constexpr std::size_t AlignedSize = 8 * LeafSize;  // nodes from here down are split at full blocks
constexpr float Infinity = std::numeric_limits<float>::infinity();
constexpr const char* TooMany = "a kd-tree holds at most 2^31 - 1 points in 2^28 blocks of 8";

struct Item {
    std::array<float, 3> at;
    std::int32_t index;
};

struct Extent {
    std::array<float, 3> low{Infinity, Infinity, Infinity}, high{-Infinity, -Infinity, -Infinity};
    std::array<double, 3> mean{};
};

Extent extentOf(std::span<const Item> items) {
    constexpr std::size_t Chunk = 1024;  // few enough for a sum of floats
    Extent result;
    for (std::size_t first = 0; first < items.size(); first += Chunk) {
        std::array<float, 3> sum{};
        for (const Item& item : items.subspan(first, std::min(Chunk, items.size() - first))) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                result.low[axis] = std::min(result.low[axis], item.at[axis]);
                result.high[axis] = std::max(result.high[axis], item.at[axis]);
                sum[axis] += item.at[axis];
            }
        }
        for (std::size_t axis = 0; axis < 3; ++axis) result.mean[axis] += static_cast<double>(sum[axis]);
    }
    for (double& mean : result.mean) mean /= static_cast<double>(items.size());
    return result;
}

std::size_t longestSide(const Extent& extent) {
    std::size_t longest = 0;
    float length = -1.0F;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float side = extent.high[axis] / 2 - extent.low[axis] / 2;
        if (side > length) length = side, longest = axis;
    }
    return longest;
}

/// Moves the items below @p limit to the front, without a branch on the data; returns how many.
std::size_t partition(std::span<Item> items, std::size_t axis, float limit) {
    std::size_t below = 0;
    for (Item& item : items) {
        const Item moved = item;
        item = items[below];
        items[below] = moved;
        below += moved.at[axis] < limit ? 1U : 0U;
    }
    return below;
}

class Builder {
public:
    explicit Builder(std::vector<Item> items) : m_items(std::move(items)) {}

    KdStorage build() {
        m_tree.size = m_items.size();
        m_tree.blocks.reserve(m_items.size() / BlockSize * 9 / 8 + 8);
        m_tree.nodes.reserve(m_items.size() / (LeafSize / 4) + 1);
        if (!m_items.empty()) m_tree.root = subtree(m_items, 0).ref;
        m_tree.nodes.shrink_to_fit();
        m_tree.blocks.shrink_to_fit();
        m_tree.indices.shrink_to_fit();
        return std::move(m_tree);
    }

private:
    struct Child {
        KdRef ref;
        Extent extent;
    };

    Child subtree(std::span<Item> items, int depth) {
        const Extent extent = extentOf(items);
        if (items.size() <= LeafSize) return {leaf(items), extent};
        const std::size_t below = split(items, extent, depth);
        const std::size_t node = m_tree.nodes.size();
        m_tree.nodes.emplace_back();
        const Child left = subtree(items.first(below), depth + 1);
        const Child right = subtree(items.subspan(below), depth + 1);
        join(m_tree.nodes[node], left, right, longestSide(extent));
        return {KdRef(static_cast<std::uint32_t>(node), 0), extent};
    }

    /// Splits the items into two groups and returns the size of the first one; neither is empty.
    static std::size_t split(std::span<Item> items, const Extent& extent, int depth) {
        const std::size_t axis = longestSide(extent);
        const auto less = [axis](const Item& a, const Item& b) { return a.at[axis] < b.at[axis]; };
        const auto place = [&](std::size_t i) { return items.begin() + static_cast<std::ptrdiff_t>(i); };
        std::size_t below = 0;
        if (depth < MaxMeanDepth) below = partition(items, axis, static_cast<float>(extent.mean[axis]));
        if (below == 0 || below == items.size()) {  // equal points, or too deep
            below = items.size() / 2 / BlockSize * BlockSize;
            std::nth_element(items.begin(), place(below), items.end(), less);
        } else if (items.size() <= AlignedSize) {
            const std::size_t full = std::max(BlockSize, (below + BlockSize / 2) / BlockSize * BlockSize);
            if (full < below) std::nth_element(items.begin(), place(full), place(below), less);
            if (full > below && full < items.size())
                std::nth_element(place(below), place(full), items.end(), less);
            if (full < items.size()) below = full;
        }
        return below;
    }

    KdRef leaf(std::span<const Item> items) {
        const std::size_t count = (items.size() + BlockSize - 1) / BlockSize;
        if (m_tree.blocks.size() + count > KdRef::MostIndices) throw std::length_error(TooMany);
        const KdRef ref(static_cast<std::uint32_t>(m_tree.blocks.size()), static_cast<std::uint32_t>(count));
        for (std::size_t first = 0; first < items.size(); first += BlockSize) {
            KdBlock& block = m_tree.blocks.emplace_back();
            for (std::size_t i = 0; i < BlockSize; ++i) {
                const bool used = first + i < items.size();
                const Item item = used ? items[first + i] : Item{{Infinity, Infinity, Infinity}, -1};
                block.x[i] = item.at[0];
                block.y[i] = item.at[1];
                block.z[i] = item.at[2];
                m_tree.indices.push_back(item.index);
            }
        }
        return ref;
    }

    static KdBox boxOf(const Extent& extent) {
        return {extent.low, {-extent.high[0], -extent.high[1], -extent.high[2]}};
    }

    static void join(KdNode& node, const Child& left, const Child& right, std::size_t axis) {
        node.boxes = {boxOf(left.extent), boxOf(right.extent)};
        node.children = {left.ref, right.ref};
        node.axis = static_cast<std::uint32_t>(axis);
        // Halfway between the children; only which child is visited first depends on it.
        node.split = left.extent.high[axis] / 2 + right.extent.low[axis] / 2;
    }

    std::vector<Item> m_items;
    KdStorage m_tree;
};

std::vector<Item> finite(std::span<const Eigen::Vector3f> points, auto indexAt, std::size_t count) {
    if (count > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
        throw std::length_error(TooMany);
    }
    std::vector<Item> items;
    items.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::int32_t index = indexAt(i);
        const Eigen::Vector3f& point = points[static_cast<std::size_t>(index)];
        if (point.allFinite()) items.push_back({{point.x(), point.y(), point.z()}, index});
    }
    return items;
}

}  // namespace

KdStorage buildKdTree(std::span<const Eigen::Vector3f> points) {
    return Builder(finite(
                       points, [](std::size_t i) { return static_cast<std::int32_t>(i); }, points.size()))
        .build();
}

KdStorage buildKdTree(std::span<const Eigen::Vector3f> points, std::span<const std::int32_t> chosen) {
    return Builder(finite(
                       points, [chosen](std::size_t i) { return chosen[i]; }, chosen.size()))
        .build();
}

}  // namespace leitstand::detail
