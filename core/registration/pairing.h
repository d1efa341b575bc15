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
    std::int32_t index = -1;       ///< index in the target cloud; -1: no permitted point is near enough
    float squaredDistance = 0.0F;  ///< squared distance [m^2]; valid only if there is a partner
};

/// Finds the closest pairs for ICP. It remembers the partner of every point. This limits the next search, as
/// the new partner is never farther than the old one. Refers to both clouds and the search, which must
/// outlive it. One thread at a time.
class Pairing {
public:
    /// @p threads: 0 means one per core; results do not depend on it. @p facing: points whose normals are
    /// more than 120 degrees apart are never paired, because they are on opposite sides of a wall. This needs
    /// normals of both clouds that point to where each point was seen from; without them it is ignored. If
    /// the nearest point faces away, the former partner is kept as long as it is near enough.
    Pairing(const PointCloud& target, const Search& search, const PointCloud& source, int threads,
            bool facing = false);

    /// Finds the partner of each source point, at @p sourceInTarget, within @p maxDistance [m]. Returns the
    /// sums over these pairs, with the source points in the target's frame. When @p stop is requested,
    /// returns early with invalid sums.
    PairSums update(const Pose& sourceInTarget, double maxDistance, const std::stop_token& stop = {});

    [[nodiscard]] const std::vector<Partner>& partners() const { return m_partners; }
    /// The result of the last update().
    [[nodiscard]] const PairSums& sums() const { return m_sums; }
    [[nodiscard]] const PointCloud& target() const { return m_target; }
    [[nodiscard]] const PointCloud& source() const { return m_source; }
    [[nodiscard]] int threads() const { return m_threads; }

    /// Number of points in a chunk; the chunks' sums are added in a fixed order.
    static constexpr std::size_t Grain = 1'024;

private:
    PairSums updateChunk(std::size_t first, std::size_t last, const Eigen::Matrix3f& rotation,
                         const Eigen::Vector3f& translation, float maxSquaredDistance);

    /// Whether the point @p target of the target may be the partner of a source point. @p normal: normal of
    /// the source point, in the target's frame.
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
