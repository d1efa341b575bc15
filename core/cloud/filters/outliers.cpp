#include "core/cloud/filters/outliers.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/base/parallel.h"
#include "core/cloud/search/kd_tree.h"

namespace leitstand {
namespace {

/// The ranges along a row or column of the grid.
class RangeLine {
public:
    /// Takes @p count points from @p begin on, @p stride apart; @p ranges: of all points.
    void take(const std::vector<Eigen::Vector3f>& points, const std::vector<float>& ranges, std::size_t begin,
              std::size_t count, std::size_t stride, const MixedPixelSettings& settings) {
        m_leastStep = static_cast<float>(settings.leastStep);
        m_ranges.resize(count);
        m_steep.resize(count);
        for (std::size_t i = 0; i < count; ++i) m_ranges[i] = ranges[begin + i * stride];
        for (std::size_t i = 0; i + 1 < count; ++i) {
            const float step = m_ranges[i + 1] - m_ranges[i];
            m_steep[i] = 0;
            // Most steps are small. Without an echo no comparison holds.
            if (!(std::abs(step) > m_leastStep)) continue;
            const Eigen::Vector3f edge = points[begin + (i + 1) * stride] - points[begin + i * stride];
            const float across = std::sqrt(std::max(edge.squaredNorm() - step * step, 0.0F));
            m_steep[i] = std::abs(step) > static_cast<float>(settings.steepness) * across ? 1 : 0;
        }
        if (count > 0) m_steep[count - 1] = 0;
    }

    /// Whether the range changes steeply from the place @p i to the next one.
    [[nodiscard]] bool isSteep(std::size_t i) const { return m_steep[i] != 0; }

    /// Whether the @p width points after the place @p left all hang between it and the place after them.
    [[nodiscard]] bool hang(std::size_t left, std::size_t width) const {
        const std::size_t right = left + width + 1;
        if (right >= m_ranges.size()) return false;
        // The range must rise, or fall, steeply all the way: two points side by side are a face.
        for (std::size_t i = left; i < right; ++i) {
            const bool rises = m_ranges[i + 1] > m_ranges[i];
            if (m_steep[i] == 0 || rises != (m_ranges[right] > m_ranges[left])) return false;
        }
        return leaves(left, left + 1, left > 0 ? left - 1 : left) &&
               leaves(right, right - 1, right + 1 < m_ranges.size() ? right + 1 : right);
    }

private:
    /// Whether the point @p next to @p end is off the surface that ends with @p end and goes on to @p inner.
    [[nodiscard]] bool leaves(std::size_t end, std::size_t next, std::size_t inner) const {
        const float range = m_ranges[end];
        // On a plane the inverse ranges of beams at even angles are, for small angles, on a line.
        const float expected = 1.0F / (2.0F / range - 1.0F / m_ranges[inner]);
        if (!(expected > 0.0F)) return true;  // no surface, or the horizon
        constexpr float SlopeError = 0.2F;
        return std::abs(m_ranges[next] - expected) > m_leastStep + SlopeError * std::abs(expected - range);
    }

    std::vector<float> m_ranges;        ///< NaN: no echo [m]
    std::vector<std::uint8_t> m_steep;  ///< whether the step to the next point is steep; 0 without echo
    float m_leastStep = 0.0F;
};

/// Marks the mixed pixels along @p line of the grid, which begins at the point @p begin.
void markLine(const RangeLine& line, std::size_t begin, std::size_t count, std::size_t stride,
              const MixedPixelSettings& settings, std::vector<bool>& mixed) {
    for (std::size_t left = 0; left + 2 < count; ++left) {
        if (!line.isSteep(left)) continue;
        for (std::size_t width = 1; width <= static_cast<std::size_t>(std::max(settings.widest, 0));
             ++width) {
            if (!line.hang(left, width)) continue;
            for (std::size_t i = 1; i <= width; ++i) mixed[begin + (left + i) * stride] = true;
        }
    }
}

}  // namespace

PointCloud withoutIsolated(const PointCloud& cloud, const IsolationSettings& settings) {
    constexpr std::size_t Grain = 2048;
    const KdTree tree(cloud.points);
    std::vector<std::uint8_t> kept(cloud.size());
    // The nearest include the point itself.
    const auto wanted = static_cast<std::size_t>(std::max(settings.leastNeighbours, 0)) + 1;
    parallelFor(cloud.size(), Grain, settings.threads, [&](std::size_t first, std::size_t last) {
        std::vector<Neighbour> near;
        for (std::size_t i = first; i < last; ++i) {
            const double range = cloud.points[i].cast<double>().norm();
            const double radius = std::max(settings.radius, settings.radiusPerRange * range);
            tree.kNearest(cloud.points[i], wanted, near);
            kept[i] =
                near.size() == wanted && static_cast<double>(near.back().squaredDistance) < radius * radius;
        }
    });
    PointCloud result;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        if (kept[i] == 0) continue;
        result.points.push_back(cloud.points[i]);
        if (!cloud.normals.empty()) result.normals.push_back(cloud.normals[i]);
        if (!cloud.labels.empty()) result.labels.push_back(cloud.labels[i]);
        if (!cloud.weights.empty()) result.weights.push_back(cloud.weights[i]);
    }
    return result;
}

std::vector<bool> mixedPixels(const Scan& scan, const MixedPixelSettings& settings) {
    std::vector<bool> mixed(scan.points.size());
    if (!scan.organised()) return mixed;
    const auto rows = static_cast<std::size_t>(scan.rows), columns = static_cast<std::size_t>(scan.columns);
    assert(scan.points.size() == rows * columns);
    std::vector<float> ranges(scan.points.size());  // NaN: no echo [m]
    std::transform(scan.points.begin(), scan.points.end(), ranges.begin(), [](const Eigen::Vector3f& point) {
        const float range = point.norm();
        return range > 0.0F ? range : std::numeric_limits<float>::quiet_NaN();
    });
    RangeLine line;
    const auto mark = [&](std::size_t begin, std::size_t count, std::size_t stride) {
        line.take(scan.points, ranges, begin, count, stride, settings);
        markLine(line, begin, count, stride, settings, mixed);
    };
    for (std::size_t row = 0; row < rows; ++row) mark(row * columns, columns, 1);
    for (std::size_t column = 0; column < columns; ++column) mark(column, rows, columns);
    return mixed;
}

Scan withoutMixedPixels(Scan scan, const MixedPixelSettings& settings) {
    const std::vector<bool> mixed = mixedPixels(scan, settings);
    for (std::size_t i = 0; i < mixed.size(); ++i) {
        if (mixed[i]) scan.points[i].setConstant(std::numeric_limits<float>::quiet_NaN());
    }
    return scan;
}

}  // namespace leitstand
