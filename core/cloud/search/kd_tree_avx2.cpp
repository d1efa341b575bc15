#include "core/cloud/search/kd_tree_nearest.h"

#if defined(__x86_64__)

#include <immintrin.h>

#include "core/cloud/search/kd_tree_descent.h"

// Without FMA on purpose: a fused step would round differently from the plain path. No Eigen type is passed
// by value here.
#define LEITSTAND_AVX2 __attribute__((target("avx2")))

namespace leitstand::detail {
namespace {

/// Squared distance of a query from @p box, computed like boxDistance() of the descent. @p query: x y z and
/// anything.
LEITSTAND_AVX2 inline float boxDistance(const KdBox& box, __m128 query) {
    const __m128 below = _mm_sub_ps(_mm_loadu_ps(box.low.data()), query);
    const __m128 lastAndHigh = _mm_loadu_ps(box.low.data() + 2);  // low.z, then all of negativeHigh
    const __m128 high = _mm_shuffle_ps(lastAndHigh, lastAndHigh, _MM_SHUFFLE(0, 3, 2, 1));
    const __m128 outside = _mm_max_ps(_mm_max_ps(below, _mm_add_ps(high, query)), _mm_setzero_ps());
    const __m128 squares = _mm_mul_ps(outside, outside);
    const __m128 xy = _mm_add_ss(squares, _mm_movehdup_ps(squares));
    return _mm_cvtss_f32(_mm_add_ss(xy, _mm_movehl_ps(squares, squares)));
}

/// The least of eight.
LEITSTAND_AVX2 inline float least(__m256 values) {
    __m128 four = _mm_min_ps(_mm256_castps256_ps128(values), _mm256_extractf128_ps(values, 1));
    four = _mm_min_ps(four, _mm_movehl_ps(four, four));
    return _mm_cvtss_f32(_mm_min_ss(four, _mm_shuffle_ps(four, four, 1)));
}

/// The nearest points so far, one for each of the eight places of a block. They are joined only at the end,
/// so that no branch depends on the contents of a leaf.
struct Nearest {
    __m256 distances;
    __m256i blocks;
};

LEITSTAND_AVX2 inline void searchLeaf(const KdBlock* blocks, KdRef leaf, const __m256 (&query)[3],
                                      Nearest& best) {
    for (std::uint32_t i = leaf.first(); i < leaf.end(); ++i) {
        const __m256 dx = _mm256_sub_ps(query[0], _mm256_load_ps(blocks[i].x.data()));
        const __m256 dy = _mm256_sub_ps(query[1], _mm256_load_ps(blocks[i].y.data()));
        const __m256 dz = _mm256_sub_ps(query[2], _mm256_load_ps(blocks[i].z.data()));
        const __m256 xy = _mm256_add_ps(_mm256_mul_ps(dx, dx), _mm256_mul_ps(dy, dy));
        const __m256 distances = _mm256_add_ps(xy, _mm256_mul_ps(dz, dz));
        const __m256 nearer = _mm256_cmp_ps(distances, best.distances, _CMP_LT_OQ);
        best.distances = _mm256_min_ps(distances, best.distances);
        best.blocks = _mm256_blendv_epi8(best.blocks, _mm256_set1_epi32(static_cast<int>(i)),
                                         _mm256_castps_si256(nearer));
    }
}

LEITSTAND_AVX2 inline KdFound nearestOf(const Nearest& best, float maxSquaredDistance) {
    const float distance = least(best.distances);
    if (!(distance < maxSquaredDistance)) return {KdFound::None, maxSquaredDistance};
    const int lanes = _mm256_movemask_ps(_mm256_cmp_ps(best.distances, _mm256_set1_ps(distance), _CMP_EQ_OQ));
    const auto lane = static_cast<std::uint32_t>(__builtin_ctz(static_cast<unsigned>(lanes)));
    alignas(32) std::uint32_t blocks[BlockSize];
    _mm256_store_si256(reinterpret_cast<__m256i*>(blocks), best.blocks);
    return {blocks[lane] * static_cast<std::uint32_t>(BlockSize) + lane, distance};
}

}  // namespace

LEITSTAND_AVX2 KdFound nearestAvx2(const KdStorage& tree, const Eigen::Vector3f& query,
                                   float maxSquaredDistance, float shrink) {
    if (tree.empty() || !(maxSquaredDistance > 0.0F)) return {KdFound::None, maxSquaredDistance};
    const KdNode* nodes = tree.nodes.data();
    const float* q = query.data();
    const __m128 boxQuery = _mm_setr_ps(q[0], q[1], q[2], 0.0F);
    const __m256 blockQuery[3] = {_mm256_set1_ps(q[0]), _mm256_set1_ps(q[1]), _mm256_set1_ps(q[2])};
    Nearest best{_mm256_set1_ps(maxSquaredDistance), _mm256_setzero_si256()};
    float bound = maxSquaredDistance;
    KdWaiting waiting[MaxDepth];
    std::size_t count = 0;
    KdRef ref = tree.root;
    for (;;) {
        // Down to a leaf. The child is chosen by a branch on purpose: the processor goes on with the child it
        // expects, instead of waiting for one node after the other. Measured on the hall, that nearly halves
        // the time of queries in scan order and pays with shuffled ones too.
        while (ref.isNode()) {
            const KdNode& node = nodes[ref.first()];
            if (q[node.axis] < node.split) {
                ref = node.children[0];
                const float distance = boxDistance(node.boxes[1], boxQuery);
                if (distance < bound) waiting[count++] = {node.children[1], distance};
            } else {
                ref = node.children[1];
                const float distance = boxDistance(node.boxes[0], boxQuery);
                if (distance < bound) waiting[count++] = {node.children[0], distance};
            }
        }
        searchLeaf(tree.blocks.data(), ref, blockQuery, best);
        // A found distance is multiplied by shrink, the caller's bound is not: a point just below it counts.
        const float distance = least(best.distances);
        bound = distance < maxSquaredDistance ? distance * shrink : maxSquaredDistance;
        do {
            if (count == 0) return nearestOf(best, maxSquaredDistance);
            --count;
        } while (!(waiting[count].squaredDistance < bound));
        ref = waiting[count].ref;
    }
}

}  // namespace leitstand::detail

#endif
