#include "core/cloud/labels.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "core/cloud/filters/grid_tangents.h"
#include "core/cloud/filters/normals.h"

namespace leitstand {
namespace {

/// Finds the label of a surface from its normal.
class Labeller {
public:
    explicit Labeller(const LabelSettings& settings)
        : m_up(settings.up.normalized().cast<float>()),
          m_level(static_cast<float>(std::cos(settings.steepest))) {}

    /// Label of a surface with @p normal towards the sensor, of any length; zero: Unlabelled.
    [[nodiscard]] Label operator()(const Eigen::Vector3f& normal) const {
        const float length = normal.norm();
        if (!(length > 0.0F)) return Label::Unlabelled;
        const float upwards = normal.dot(m_up);
        if (upwards >= m_level * length) return Label::Floor;
        return upwards <= -m_level * length ? Label::Ceiling : Label::Wall;
    }

    /// Returns the normal of a surface at @p point when only the direction along the vertical raw scan is
    /// known. It lies within the plane of that raw scan; zero where this plane is too far from vertical.
    [[nodiscard]] Eigen::Vector3f profileNormal(const Eigen::Vector3f& tangent,
                                                const Eigen::Vector3f& point) const {
        constexpr float MostTilt = 0.5F;  // sine of 30 degrees
        const Eigen::Vector3f across = tangent.cross(point);
        if (!(std::abs(across.dot(m_up)) < MostTilt * across.norm())) return Eigen::Vector3f::Zero();
        const Eigen::Vector3f normal = across.cross(tangent);
        return normal.dot(point) > 0.0F ? Eigen::Vector3f(-normal) : normal;
    }

private:
    Eigen::Vector3f m_up;
    float m_level;  ///< cosine of the steepest slope
};

}  // namespace

bool leavesPlane(std::span<const Eigen::Vector3f> points) {
    return std::any_of(points.begin(), points.end(),
                       [](const Eigen::Vector3f& point) { return point.z() != 0.0F && point.allFinite(); });
}

bool isPlaneScan(std::span<const Eigen::Vector3f> points) {
    constexpr std::ptrdiff_t Least = 30;  // a few points may lie anywhere
    return !leavesPlane(points) &&
           std::count_if(points.begin(), points.end(),
                         [](const Eigen::Vector3f& point) { return point.allFinite(); }) >= Least;
}

std::vector<Label> labelScan(const Scan& scan, const GridTangents& tangents,
                             std::span<const Eigen::Vector3f> normals, const LabelSettings& settings) {
    assert(normals.size() == scan.points.size());
    const Labeller label(settings);
    const auto& vertical = scan.sweep == Sweep::Tilting ? tangents.alongColumns : tangents.alongRows;
    std::vector<Label> labels(scan.points.size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        labels[i] = label(normals[i]);
        if (labels[i] == Label::Unlabelled)
            labels[i] = label(label.profileNormal(vertical[i], scan.points[i]));
    }
    return labels;
}

std::vector<Label> labelScan(const Scan& scan, const LabelSettings& settings) {
    if (scan.organised()) {
        const GridTangents tangents = gridTangents(scan);
        return labelScan(scan, tangents, gridNormals(scan, tangents), settings);
    }
    if (isPlaneScan(scan.points)) {
        std::vector<Label> labels;
        labels.reserve(scan.points.size());
        for (const Eigen::Vector3f& point : scan.points)
            labels.push_back(point.allFinite() ? Label::Wall : Label::Unlabelled);
        return labels;
    }
    return labelNormals(knnNormals(scan.points), settings);
}

std::vector<Label> labelNormals(std::span<const Eigen::Vector3f> normals, const LabelSettings& settings) {
    const Labeller label(settings);
    std::vector<Label> labels(normals.size());
    for (std::size_t i = 0; i < labels.size(); ++i) labels[i] = label(normals[i]);
    return labels;
}

}  // namespace leitstand
