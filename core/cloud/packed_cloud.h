#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/cloud/scan.h"

namespace leitstand {

/// A cloud stored for later use in about half the memory: 16 bits for each coordinate of a point or normal.
/// The map of an hour has a thousand such clouds; a scan is matched against a dozen. Immutable.
class PackedCloud {
public:
    /// Packs the points, normals and labels of @p cloud, which must be finite; weights are left out.
    explicit PackedCloud(const PointCloud& cloud);

    /// Returns the cloud without weights. The error of points is at most step() / 2 along each axis; that of
    /// normals is at most 0.003 degrees.
    [[nodiscard]] PointCloud unpacked() const;
    [[nodiscard]] std::size_t size() const { return m_points.size(); }
    /// Coordinates of points are multiples of this [m]: 0.5 mm in a cloud that reaches 15 m.
    [[nodiscard]] float step() const { return m_step; }
    /// Memory held on the heap [bytes].
    [[nodiscard]] std::size_t memory() const;

    /// Returns the whole cloud as bytes, to be read by fromBytes() on this computer.
    [[nodiscard]] std::vector<std::byte> bytes() const;
    /// Reads a cloud from @p bytes, which must be a result of bytes(). Empty when their size does not fit a
    /// cloud.
    [[nodiscard]] static std::optional<PackedCloud> fromBytes(std::span<const std::byte> bytes);

private:
    using Packed = std::array<std::int16_t, 3>;

    PackedCloud() = default;
    static std::vector<Packed> packed(const std::vector<Eigen::Vector3f>& vectors, float step);
    static std::vector<Eigen::Vector3f> unpacked(const std::vector<Packed>& vectors, float step);

    float m_step = 0.0F;
    std::vector<Packed> m_points, m_normals;
    std::vector<Label> m_labels;
};

}  // namespace leitstand
