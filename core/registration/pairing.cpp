#include "core/registration/pairing.h"

#include "core/base/parallel.h"

namespace leitstand {
namespace {

constexpr float Away = -0.5F;  ///< cosine between normals, one of them on the other side of a wall

}  // namespace

Pairing::Pairing(const PointCloud& target, const Search& search, const PointCloud& source, int threads,
                 bool facing)
    : m_target(target),
      m_search(search),
      m_source(source),
      m_threads(threads),
      m_facing(facing && !target.normals.empty() && !source.normals.empty()),
      m_partners(source.size()) {}

PairSums Pairing::update(const Pose& sourceInTarget, double maxDistance, const std::stop_token& stop) {
    const Eigen::Matrix3f rotation = sourceInTarget.linear().cast<float>();
    const Eigen::Vector3f translation = sourceInTarget.translation().cast<float>();
    const auto maxSquared = static_cast<float>(maxDistance * maxDistance);
    std::vector<PairSums> chunks((m_source.size() + Grain - 1) / Grain);
    parallelFor(m_source.size(), Grain, m_threads, [&](std::size_t first, std::size_t last) {
        if (!stop.stop_requested())
            chunks[first / Grain] = updateChunk(first, last, rotation, translation, maxSquared);
    });
    m_sums = {};
    for (const PairSums& chunk : chunks) m_sums += chunk;
    return m_sums;
}

PairSums Pairing::updateChunk(std::size_t first, std::size_t last, const Eigen::Matrix3f& rotation,
                              const Eigen::Vector3f& translation, float maxSquaredDistance) {
    PairSums sums;
    const bool labelled = !m_source.labels.empty(), weighted = !m_source.weights.empty();
    for (std::size_t i = first; i < last; ++i) {
        const Eigen::Vector3f query = rotation * m_source.points[i] + translation;
        Partner& partner = m_partners[i];
        float bound = maxSquaredDistance;
        if (partner.index >= 0) {
            partner.squaredDistance =
                (m_target.points[static_cast<std::size_t>(partner.index)] - query).squaredNorm();
            if (partner.squaredDistance < bound) {
                bound = partner.squaredDistance;
            } else {
                partner.index = -1;
            }
        }
        const Neighbour nearer =
            m_search.nearest(query, labelled ? m_source.labels[i] : Label::Unlabelled, bound);
        if (nearer.found() && (!m_facing || fits(rotation * m_source.normals[i], nearer.index)))
            partner = {nearer.index, nearer.squaredDistance};
        if (partner.index < 0) continue;
        sums.add(query.cast<double>(),
                 m_target.points[static_cast<std::size_t>(partner.index)].cast<double>(),
                 weighted ? static_cast<double>(m_source.weights[i]) : 1.0);
    }
    return sums;
}

bool Pairing::fits(const Eigen::Vector3f& normal, std::int32_t target) const {
    return m_target.normals[static_cast<std::size_t>(target)].dot(normal) > Away;
}

}  // namespace leitstand
