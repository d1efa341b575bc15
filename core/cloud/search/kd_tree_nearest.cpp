#include "core/cloud/search/kd_tree_nearest.h"

#include "core/cloud/search/kd_tree_descent.h"

namespace leitstand::detail {

KdFound nearestPlain(const KdStorage& tree, const Eigen::Vector3f& query, float maxSquaredDistance,
                     float shrink) {
    KdFound best{KdFound::None, maxSquaredDistance};
    float bound = maxSquaredDistance;
    descend(tree, query, bound, [&](KdRef leaf) {
        for (std::uint32_t block = leaf.first(); block < leaf.end(); ++block) {
            const auto distances = blockDistances(tree.blocks[block], query);
            for (std::uint32_t i = 0; i < BlockSize; ++i) {
                if (distances[i] < best.squaredDistance) best = {block * 8 + i, distances[i]};
            }
        }
        if (best.place != KdFound::None) bound = best.squaredDistance * shrink;  // not the caller's bound
    });
    return best;
}

}  // namespace leitstand::detail
