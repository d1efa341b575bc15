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

/// A row or column of the grid as the ranges along it.
class RangeLine {
public:
    RangeLine(const std::vector<Eigen::Vector3f>& points, std::size_t begin, std::size_t count,
              std::size_t stride, const MixedPixelSettings& settings)
        : m_ranges(count), m_steep(count), m_leastStep(static_cast<float>(settings.leastStep)) {
        for (std::size_t i = 0; i < count; ++i) {
            const float range = points[begin + i * stride].norm();
            m_ranges[i] = range > 0.0F ? range : std::numeric_limits<float>::quiet_NaN();
        }
        for (std::size_t i = 0; i + 1 < count; ++i) {
            const float step = m_ranges[i + 1] - m_ranges[i];
            const Eigen::Vector3f edge = points[begin + (i + 1) * stride] - points[begin + i * stride];
            const float across = std::sqrt(std::max(edge.squaredNorm() - step * step, 0.0F));
            m_steep[i] =
                std::abs(step) > std::max(m_leastStep, static_cast<float>(settings.steepness) * across);
        }
    }

    /// Whether the @p width points behind the place @p left all hang between it and the one behind them.
    [[nodiscard]] bool hang(std::size_t left, std::size_t width) const {
        const std::size_t right = left + width + 1;
        if (right >= m_ranges.size()) return false;
        // The range has to rise, or fall, steeply all the way: two points side by side are a face.
        for (std::size_t i = left; i < right; ++i) {
            const bool rises = m_ranges[i + 1] > m_ranges[i];
            if (!m_steep[i] || rises != (m_ranges[right] > m_ranges[left])) return false;
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
        if (!(expected > 0.0F)) return true;  // nothing, or the horizon
        constexpr float SlopeError = 0.2F;
        return std::abs(m_ranges[next] - expected) > m_leastStep + SlopeError * std::abs(expected - range);
    }

    std::vector<float> m_ranges;  ///< NaN: no echo [m]
    std::vector<bool> m_steep;    ///< the step from each point to the next one; false without echo
    float m_leastStep;
};

/// Marks the mixed pixels along a line of the grid: @p count points from @p begin on, @p stride apart.
void markLine(const std::vector<Eigen::Vector3f>& points, std::size_t begin, std::size_t count,
              std::size_t stride, const MixedPixelSettings& settings, std::vector<bool>& mixed) {
    const RangeLine line(points, begin, count, stride, settings);
    for (std::size_t left = 0; left + 2 < count; ++left) {
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
    // The point itself is among the nearest.
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
    for (std::size_t row = 0; row < rows; ++row) {
        markLine(scan.points, row * columns, columns, 1, settings, mixed);
    }
    for (std::size_t column = 0; column < columns; ++column) {
        markLine(scan.points, column, rows, columns, settings, mixed);
    }
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
