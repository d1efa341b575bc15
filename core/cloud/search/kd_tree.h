#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/base/simd.h"
#include "core/cloud/search/kd_tree_layout.h"
#include "core/cloud/search/kd_tree_nearest.h"
#include "core/cloud/search/search.h"

namespace leitstand {

/// An optimised kd-tree (Friedman, Bentley & Finkel 1977) over a copy of the points [m]; about 17 bytes per
/// point. Points that are not finite are left out. Queries must be finite; concurrent queries are safe.
class KdTree {
public:
    static constexpr float Unbounded = std::numeric_limits<float>::infinity();

    /// An empty tree, which finds nothing.
    KdTree() = default;
    /// A tree over all @p points. Throws std::length_error beyond some 2^31 points.
    explicit KdTree(std::span<const Eigen::Vector3f> points, SimdLevel simd = simdLevel());
    /// A tree over the points with the indices @p chosen. Results are indices into @p points.
    KdTree(std::span<const Eigen::Vector3f> points, std::span<const std::int32_t> chosen,
           SimdLevel simd = simdLevel());

    /// Returns the nearest point whose squared distance is below @p maxSquaredDistance [m^2]. The distance is
    /// the same to the last bit as that of a search through all points. Of equally near points, any may be
    /// found.
    [[nodiscard]] Neighbour nearest(const Eigen::Vector3f& query,
                                    float maxSquaredDistance = Unbounded) const {
        return neighbour(m_nearest(m_storage, query, maxSquaredDistance, 1.0F));
    }

    /// Returns a point whose squared distance is below @p maxSquaredDistance [m^2], and which is at most (1 +
    /// @p epsilon) times as far as the nearest point. Finds a point whenever nearest() does (Arya & Mount
    /// 1993).
    [[nodiscard]] Neighbour nearestApproximate(const Eigen::Vector3f& query, double epsilon,
                                               float maxSquaredDistance = Unbounded) const {
        return neighbour(m_nearest(m_storage, query, maxSquaredDistance, shrinkOf(epsilon)));
    }

    /// Writes the @p k nearest points to @p out, nearest first; all points if there are fewer.
    void kNearest(const Eigen::Vector3f& query, std::size_t k, std::vector<Neighbour>& out) const;

    /// Writes the points nearer than @p radius [m] to @p out, in any order.
    void withinRadius(const Eigen::Vector3f& query, float radius, std::vector<Neighbour>& out) const;

    /// Number of points in the tree.
    [[nodiscard]] std::size_t size() const { return m_storage.size; }
    /// Memory used on the heap [B].
    [[nodiscard]] std::size_t memory() const;

private:
    [[nodiscard]] static float shrinkOf(double epsilon);
    [[nodiscard]] Neighbour neighbour(detail::KdFound found) const {
        if (found.place == detail::KdFound::None) return {};
        return {m_storage.indices[found.place], found.squaredDistance};
    }

    detail::KdStorage m_storage;
    detail::KdNearest m_nearest = detail::nearestPlain;
};

}  // namespace leitstand
