#include "core/cloud/packed_cloud.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace leitstand {
namespace {

constexpr auto Most = static_cast<float>(std::numeric_limits<std::int16_t>::max());
constexpr float NormalStep = 1.0F / Most;

/// Returns the step [m]: a whole number of steps covers the farthest coordinate.
float stepOf(const std::vector<Eigen::Vector3f>& points) {
    float farthest = 0.0F;
    for (const Eigen::Vector3f& point : points) farthest = std::max(farthest, point.cwiseAbs().maxCoeff());
    return farthest > 0.0F ? farthest / Most : NormalStep;
}

/// Header of a cloud's bytes.
struct Head {
    float step = 0.0F;
    std::uint32_t points = 0, normals = 0, labels = 0;
};

/// Copies @p list to the beginning of @p bytes, which has room for it, and moves @p bytes past it.
template <typename T>
void put(std::span<std::byte>& bytes, const std::vector<T>& list) {
    if (!list.empty()) std::memcpy(bytes.data(), list.data(), list.size() * sizeof(T));
    bytes = bytes.subspan(list.size() * sizeof(T));
}

/// Takes @p count elements from the beginning of @p bytes, which has them, and moves @p bytes past them.
template <typename T>
std::vector<T> taken(std::span<const std::byte>& bytes, std::size_t count) {
    std::vector<T> list(count);
    if (count > 0) std::memcpy(list.data(), bytes.data(), count * sizeof(T));
    bytes = bytes.subspan(count * sizeof(T));
    return list;
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

std::vector<std::byte> PackedCloud::bytes() const {
    const auto count = [](const auto& list) { return static_cast<std::uint32_t>(list.size()); };
    const std::vector<Head> head = {{m_step, count(m_points), count(m_normals), count(m_labels)}};
    const std::size_t vectors = m_points.size() + m_normals.size();
    std::vector<std::byte> bytes(sizeof(Head) + sizeof(Packed) * vectors + m_labels.size());
    std::span<std::byte> rest(bytes);
    put(rest, head);
    put(rest, m_points);
    put(rest, m_normals);
    put(rest, m_labels);
    return bytes;
}

std::optional<PackedCloud> PackedCloud::fromBytes(std::span<const std::byte> bytes) {
    if (bytes.size() < sizeof(Head)) return std::nullopt;
    const Head head = taken<Head>(bytes, 1).front();
    const std::size_t vectors = std::size_t{head.points} + head.normals;
    if (bytes.size() != sizeof(Packed) * vectors + head.labels) return std::nullopt;
    PackedCloud cloud;
    cloud.m_step = head.step;
    cloud.m_points = taken<Packed>(bytes, head.points);
    cloud.m_normals = taken<Packed>(bytes, head.normals);
    cloud.m_labels = taken<Label>(bytes, head.labels);
    return cloud;
}

}  // namespace leitstand
