#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/base/pose.h"
#include "core/cloud/scan.h"
#include "core/cloud/search/search.h"
#include "core/registration/pair_sums.h"

namespace leitstand {

/// A source point with its partner in the target.
struct Partner {
    std::int32_t index = -1;       ///< in the target cloud; -1: no permitted point is near enough
    float squaredDistance = 0.0F;  ///< [m^2]; only where there is a partner
};

/// Finds the closest pairs of an ICP. It remembers every point's partner, which bounds the next search: the
/// new partner is never farther than the old one. Refers to both clouds and the search, which must outlive
/// it. One thread at a time.
class Pairing {
public:
    /// @p threads: 0 is one per core; results do not depend on it. @p facing: points whose normals are more
    /// than 120 degrees apart make no pair, as they lie on opposite sides of a wall. This needs normals of
    /// both clouds, towards where each point was seen from; without them it is ignored. If the nearest point
    /// faces away, the former partner stays, provided it is still near enough.
    Pairing(const PointCloud& target, const Search& search, const PointCloud& source, int threads,
            bool facing = false);

    /// Finds for each source point, at @p sourceInTarget, its partner nearer than @p maxDistance [m]. Returns
    /// the sums over these pairs, with the source points in the target's frame. Ends early, with invalid
    /// sums, once @p stop is requested.
    PairSums update(const Pose& sourceInTarget, double maxDistance, const std::stop_token& stop = {});

    [[nodiscard]] const std::vector<Partner>& partners() const { return m_partners; }
    /// The result of the last update().
    [[nodiscard]] const PairSums& sums() const { return m_sums; }
    [[nodiscard]] const PointCloud& target() const { return m_target; }
    [[nodiscard]] const PointCloud& source() const { return m_source; }
    [[nodiscard]] int threads() const { return m_threads; }

    static constexpr std::size_t Grain = 1'024;  ///< points of a chunk; sums are joined in the chunks' order

private:
    PairSums updateChunk(std::size_t first, std::size_t last, const Eigen::Matrix3f& rotation,
                         const Eigen::Vector3f& translation, float maxSquaredDistance);

    /// Whether the point @p target of the target may be the partner of a source point. @p normal: of the
    /// source point, in the target's frame.
    [[nodiscard]] bool fits(const Eigen::Vector3f& normal, std::int32_t target) const;

    const PointCloud& m_target;
    const Search& m_search;
    const PointCloud& m_source;
    int m_threads;
    bool m_facing;
    std::vector<Partner> m_partners;
    PairSums m_sums;
};

}  // namespace leitstand
