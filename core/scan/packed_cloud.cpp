#include "core/scan/packed_cloud.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace leitstand {
namespace {

constexpr auto Most = static_cast<float>(std::numeric_limits<std::int16_t>::max());
constexpr float NormalStep = 1.0F / Most;

/// A whole number of steps covers the farthest coordinate.
float stepOf(const std::vector<Eigen::Vector3f>& points) {
    float farthest = 0.0F;
    for (const Eigen::Vector3f& point : points) farthest = std::max(farthest, point.cwiseAbs().maxCoeff());
    return farthest > 0.0F ? farthest / Most : NormalStep;
}

}  // namespace

PackedCloud::PackedCloud(const PointCloud& cloud)
    : m_step(stepOf(cloud.points)),
      m_points(packed(cloud.points, m_step)),
      m_normals(packed(cloud.normals, NormalStep)),
      m_labels(cloud.labels.begin(), cloud.labels.end()) {}

std::vector<PackedCloud::Packed> PackedCloud::packed(const std::vector<Eigen::Vector3f>& vectors,
                                                     float step) {
    const auto whole = [step](float value) {
        return static_cast<std::int16_t>(std::lround(std::clamp(value / step, -Most, Most)));
    };
    std::vector<Packed> result;
    result.reserve(vectors.size());
    for (const Eigen::Vector3f& one : vectors)
        result.push_back({whole(one.x()), whole(one.y()), whole(one.z())});
    return result;
}

std::vector<Eigen::Vector3f> PackedCloud::unpacked(const std::vector<Packed>& vectors, float step) {
    std::vector<Eigen::Vector3f> result;
    result.reserve(vectors.size());
    for (const Packed& one : vectors) {
        result.emplace_back(step * static_cast<float>(one[0]), step * static_cast<float>(one[1]),
                            step * static_cast<float>(one[2]));
    }
    return result;
}

PointCloud PackedCloud::unpacked() const {
    PointCloud cloud;
    cloud.points = unpacked(m_points, m_step);
    cloud.normals = unpacked(m_normals, NormalStep);
    cloud.labels = m_labels;
    return cloud;
}

std::size_t PackedCloud::memory() const {
    return m_points.capacity() * sizeof(Packed) + m_normals.capacity() * sizeof(Packed) +
           m_labels.capacity() * sizeof(Label);
}

}  // namespace leitstand
