#include "core/registration/gicp_sums.h"

#include <algorithm>
#include <array>
#include <vector>

namespace leitstand {
namespace {

constexpr float AcrossVariance = 1e-3F;
constexpr std::size_t Lanes = 8;
using Lane = std::array<float, Lanes>;
using Lane3 = std::array<Lane, 3>;

/// Eight pairs, coordinate by coordinate: the compiler turns loops over them into vector instructions. An
/// unused lane has weight 0.
struct PairBlock {
    Lane3 arm{}, residual{};   ///< source point from the centre; from its partner [m]
    Lane3 source{}, target{};  ///< normals in the target's frame, unit length or zero
    Lane weight{};
    Lane costShare{};  ///< factor from a weighted square to its cost
};

/// Sums over pairs, lane by lane: the hessian's upper triangle, the gradient, the cost.
struct LaneSums {
    std::array<Lane, 21> hessian{};
    std::array<Lane, 6> gradient{};
    Lane cost{};
};

/// Adds factor * row * row^T, with its share of gradient and cost, for the row made of @p direction and its
/// turn about the centre.
inline void addRow(const PairBlock& block, const Lane3& direction, const Lane& factor, LaneSums& sums) {
    std::array<Lane, 6> row;
    Lane along;
    for (std::size_t i = 0; i < Lanes; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) row[axis][i] = direction[axis][i];
        row[3][i] = block.arm[1][i] * direction[2][i] - block.arm[2][i] * direction[1][i];
        row[4][i] = block.arm[2][i] * direction[0][i] - block.arm[0][i] * direction[2][i];
        row[5][i] = block.arm[0][i] * direction[1][i] - block.arm[1][i] * direction[0][i];
        along[i] = direction[0][i] * block.residual[0][i] + direction[1][i] * block.residual[1][i] +
                   direction[2][i] * block.residual[2][i];
        sums.cost[i] += 0.5F * block.costShare[i] * factor[i] * along[i] * along[i];
    }
    std::size_t entry = 0;
    for (std::size_t r = 0; r < 6; ++r) {
        Lane scaled;
        for (std::size_t i = 0; i < Lanes; ++i) {
            scaled[i] = factor[i] * row[r][i];
            sums.gradient[r][i] += scaled[i] * along[i];
        }
        for (std::size_t c = r; c < 6; ++c, ++entry) {
            for (std::size_t i = 0; i < Lanes; ++i) sums.hessian[entry][i] += scaled[i] * row[c][i];
        }
    }
}

/// Adds eight pairs. A pair with normals a and b (turned so that a.b >= 0) has the covariance
/// 2 I - (1 - e)(a a^T + b b^T). Its eigenvectors include the bisectors a + b and a - b, so its inverse is
/// I / 2 and one rank for each.
inline void addBlock(const PairBlock& block, LaneSums& sums) {
    constexpr float k = 1.0F - AcrossVariance;
    Lane3 between, across;
    Lane betweenFactor, acrossFactor, half;
    for (std::size_t i = 0; i < Lanes; ++i) {
        float dot = 0.0F;
        for (std::size_t axis = 0; axis < 3; ++axis) dot += block.source[axis][i] * block.target[axis][i];
        const float sign = dot < 0.0F ? -1.0F : 1.0F, c = std::min(dot * sign, 1.0F);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            between[axis][i] = block.source[axis][i] + sign * block.target[axis][i];
            across[axis][i] = block.source[axis][i] - sign * block.target[axis][i];
        }
        // (1 / eigenvalue - 1 / 2) / length^2 of the bisector, simplified. Both stay finite for any c in [0,
        // 1]. A pair without normals has zero bisectors and keeps I / 2.
        betweenFactor[i] = block.weight[i] * k / (4.0F * (2.0F - k * (1.0F + c)));
        acrossFactor[i] = block.weight[i] * k / (4.0F * (2.0F - k * (1.0F - c)));
        half[i] = 0.5F * block.weight[i];
    }
    addRow(block, between, betweenFactor, sums);
    addRow(block, across, acrossFactor, sums);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Lane3 unit{};
        unit[axis].fill(1.0F);
        addRow(block, unit, half, sums);
    }
}

/// Puts a pair into a lane of @p block; a point with an unknown normal takes that of its partner. The pair
/// counts little if it is farther apart across the source's surface than @p kernel [m]; 0: no kernel.
inline void setPair(PairBlock& block, std::size_t lane, const Eigen::Vector3f& arm,
                    const Eigen::Vector3f& residual, Eigen::Vector3f sourceNormal,
                    Eigen::Vector3f targetNormal, float kernel) {
    if (sourceNormal.squaredNorm() < 0.5F) sourceNormal = targetNormal;
    if (targetNormal.squaredNorm() < 0.5F) targetNormal = sourceNormal;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<Eigen::Index>(axis);
        block.arm[axis][lane] = arm[at];
        block.residual[axis][lane] = residual[at];
        block.source[axis][lane] = sourceNormal[at];
        block.target[axis][lane] = targetNormal[at];
    }
    block.weight[lane] = block.costShare[lane] = 1.0F;
    if (kernel <= 0.0F) return;
    const float across = sourceNormal.dot(residual) / kernel, share = 1.0F / (1.0F + across * across);
    block.weight[lane] = share * share;
    block.costShare[lane] = 1.0F / share;
}

// Sanitizers are not initialised yet when the loader chooses a clone.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
__attribute__((target_clones("avx2,fma", "default")))
#endif
void addBlocks(const std::vector<PairBlock>& blocks, LaneSums& sums) {
    for (const PairBlock& block : blocks) addBlock(block, sums);
}

double total(const Lane& lane) {
    double sum = 0.0;
    for (const float value : lane) sum += static_cast<double>(value);
    return sum;
}

}  // namespace

NormalEquations gicpSums(const Pairing& pairing, const Pose& sourceInTarget, const Eigen::Vector3d& centre,
                         double kernel, std::size_t first, std::size_t last) {
    const Eigen::Matrix3f rotation = sourceInTarget.linear().cast<float>();
    const Eigen::Vector3f translation = sourceInTarget.translation().cast<float>(),
                          centreFloat = centre.cast<float>();
    const PointCloud &source = pairing.source(), &target = pairing.target();
    std::vector<PairBlock> blocks;
    blocks.reserve((last - first) / Lanes + 1);
    std::size_t lane = Lanes;
    for (std::size_t i = first; i < last; ++i) {
        const Partner& partner = pairing.partners()[i];
        if (partner.index < 0) continue;
        if (lane == Lanes) {
            blocks.emplace_back();
            lane = 0;
        }
        const auto index = static_cast<std::size_t>(partner.index);
        const Eigen::Vector3f moved = rotation * source.points[i] + translation;
        setPair(blocks.back(), lane++, moved - centreFloat, moved - target.points[index],
                rotation * source.normals[i], target.normals[index], static_cast<float>(kernel));
    }
    LaneSums sums;
    addBlocks(blocks, sums);
    NormalEquations equations;
    std::size_t entry = 0;
    for (int r = 0; r < 6; ++r) {
        equations.gradient[r] = total(sums.gradient[static_cast<std::size_t>(r)]);
        for (int c = r; c < 6; ++c)
            equations.hessian(r, c) = equations.hessian(c, r) = total(sums.hessian[entry++]);
    }
    equations.cost = total(sums.cost);
    return equations;
}

}  // namespace leitstand
