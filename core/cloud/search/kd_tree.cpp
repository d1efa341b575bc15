#include "core/cloud/search/kd_tree.h"

#include <algorithm>

#include "core/cloud/search/kd_tree_build.h"
#include "core/cloud/search/kd_tree_descent.h"

namespace leitstand {
namespace {

detail::KdNearest nearestFor([[maybe_unused]] SimdLevel simd) {
#if defined(__x86_64__)
    if (simd == SimdLevel::Avx2) return detail::nearestAvx2;
#endif
    return detail::nearestPlain;
}

}  // namespace

KdTree::KdTree(std::span<const Eigen::Vector3f> points, SimdLevel simd)
    : m_storage(detail::buildKdTree(points)), m_nearest(nearestFor(simd)) {}

KdTree::KdTree(std::span<const Eigen::Vector3f> points, std::span<const std::int32_t> chosen, SimdLevel simd)
    : m_storage(detail::buildKdTree(points, chosen)), m_nearest(nearestFor(simd)) {}

void KdTree::kNearest(const Eigen::Vector3f& query, std::size_t k, std::vector<Neighbour>& out) const {
    out.clear();
    if (k == 0) return;
    float bound = Unbounded;
    const auto nearer = [](float distance, const Neighbour& other) {
        return distance < other.squaredDistance;
    };
    detail::descend(m_storage, query, bound, [&](detail::KdRef leaf) {
        for (std::size_t block = leaf.first(); block < leaf.end(); ++block) {
            const auto distances = detail::blockDistances(m_storage.blocks[block], query);
            for (std::size_t i = 0; i < distances.size(); ++i) {
                if (!(distances[i] < bound)) continue;
                if (out.size() == k) out.pop_back();
                out.insert(std::upper_bound(out.begin(), out.end(), distances[i], nearer),
                           {m_storage.indices[block * detail::BlockSize + i], distances[i]});
                if (out.size() == k) bound = out.back().squaredDistance;
            }
        }
    });
}

void KdTree::withinRadius(const Eigen::Vector3f& query, float radius, std::vector<Neighbour>& out) const {
    out.clear();
    const float bound = radius * radius;
    detail::descend(m_storage, query, bound, [&](detail::KdRef leaf) {
        for (std::size_t block = leaf.first(); block < leaf.end(); ++block) {
            const auto distances = detail::blockDistances(m_storage.blocks[block], query);
            for (std::size_t i = 0; i < distances.size(); ++i) {
                if (!(distances[i] < bound)) continue;
                out.push_back({m_storage.indices[block * detail::BlockSize + i], distances[i]});
            }
        }
    });
}

std::size_t KdTree::memory() const {
    return m_storage.nodes.capacity() * sizeof(detail::KdNode) +
           m_storage.blocks.capacity() * sizeof(detail::KdBlock) +
           m_storage.indices.capacity() * sizeof(std::int32_t);
}

float KdTree::shrinkOf(double epsilon) {
    const double factor = 1.0 + std::max(epsilon, 0.0);
    return static_cast<float>(1.0 / (factor * factor));
}

}  // namespace leitstand
