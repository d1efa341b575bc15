#include "core/io/clouds/detail/point_sink.h"

#include <cmath>
#include <limits>

namespace leitstand::detail {

Eigen::Vector3f noEcho() {
    return Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
}

void PointSink::reserve(std::size_t points, bool intensities, bool labels) {
    m_scan.points.reserve(points);
    if (intensities) m_scan.intensities.reserve(points);
    if (labels) m_scan.labels.reserve(points);
}

std::optional<std::string_view> PointSink::addPoint(double x, double y, double z) {
    const Eigen::Vector3d point(x, y, z);
    // NaN compares false, so only infinite and far coordinates are refused.
    if ((point.array().abs() > MaxCoordinate).any()) return "finite coordinates within 100 km";
    m_scan.points.push_back(point.array().isNaN().any() ? noEcho() : point.cast<float>().eval());
    return std::nullopt;
}

std::optional<std::string_view> PointSink::addIntensity(double value) {
    const bool echo = !std::isnan(m_scan.points.back().x());
    const bool finite = std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max());
    if (echo && !finite) return "a finite intensity";
    m_scan.intensities.push_back(finite ? static_cast<float>(value) : 0.0F);
    return std::nullopt;
}

void PointSink::addLabel(double value) {
    const bool ours = value >= 0.0 && value < LabelCount && value == std::floor(value);
    if (!ours) m_foreignLabels = true;
    m_scan.labels.push_back(ours ? static_cast<Label>(static_cast<int>(value)) : Label::Unlabelled);
}

void PointSink::finish(const std::string& file, std::vector<std::string>& warnings) {
    if (!m_foreignLabels) return;
    m_scan.labels = {};
    warnings.push_back(file + ": its labels are left out, they are not numbers from 0 to 3");
}

}  // namespace leitstand::detail
