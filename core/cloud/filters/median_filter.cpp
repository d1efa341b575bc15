#include "core/cloud/filters/median_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/cloud/filters/range_filter.h"
#include "core/cloud/label_votes.h"

namespace leitstand {
namespace {

constexpr std::size_t HalfWindow = 3;  // 7 neighbours, the point itself in the middle

/// Points that become one: of one raw scan, later of successive raw scans.
struct Run {
    std::size_t firstColumn = 0, lastColumn = 0;  // in the last raw scan that it has points of
    Eigen::Vector3f first, last;  // first point; last point, or mean of the last raw scan's part
    Eigen::Vector3d points = Eigen::Vector3d::Zero();
    Eigen::Vector3f normals = Eigen::Vector3f::Zero();
    LabelVotes labels;
    double count = 0.0;

    [[nodiscard]] Eigen::Vector3f mean() const { return (points / count).cast<float>(); }
};

/// Makes runs of the points of a raw scan and joins them with those of the raw scan before.
class Reduction {
public:
    Reduction(const Scan& scan, std::span<const Eigen::Vector3f> normals,
              const MedianFilterSettings& settings)
        : m_scan(scan), m_normals(normals), m_settings(settings) {}

    void addRawScan(std::size_t row) {
        std::vector<Run> now = runsOf(row);
        std::size_t candidate = 0;
        std::vector<bool> taken(m_open.size(), false);
        for (Run& run : now) {
            // Both lists rise by columns: earlier runs that end before this one begin are no longer needed.
            while (candidate < m_open.size() && m_open[candidate].lastColumn < run.firstColumn) ++candidate;
            const std::size_t partner = nearestBefore(run, candidate, taken);
            if (partner == m_open.size()) continue;
            taken[partner] = true;
            run = joined(m_open[partner], run);
        }
        for (std::size_t i = 0; i < m_open.size(); ++i) {
            if (!taken[i]) finish(m_open[i]);
        }
        m_open = std::move(now);
    }

    PointCloud result() {
        for (const Run& run : m_open) finish(run);
        m_open.clear();
        return std::move(m_cloud);
    }

private:
    [[nodiscard]] std::vector<Run> runsOf(std::size_t row) const {
        const auto columns = static_cast<std::size_t>(m_scan.columns);
        const auto points = std::span(m_scan.points).subspan(row * columns, columns);
        std::vector<float> ranges(columns);
        std::transform(points.begin(), points.end(), ranges.begin(),
                       [](const Eigen::Vector3f& p) { return p.norm(); });
        const std::vector<float> filtered = medianFilteredRanges(ranges, m_settings.outlier);
        std::vector<Run> runs;
        bool open = false;
        for (std::size_t column = 0; column < columns; ++column) {
            if (!(filtered[column] >= m_settings.minRange && filtered[column] <= m_settings.maxRange)) {
                open = false;
                continue;
            }
            const Eigen::Vector3f point = points[column] * (filtered[column] / ranges[column]);
            if (!open || !continues(runs.back(), point)) {
                runs.emplace_back();
                runs.back().firstColumn = column;
                runs.back().first = point;
                open = true;
            }
            extend(runs.back(), point, column);
            if (filtered[column] == ranges[column]) describe(runs.back(), row * columns + column);
        }
        return runs;
    }

    [[nodiscard]] bool continues(const Run& run, const Eigen::Vector3f& point) const {
        return (point - run.last).squaredNorm() < m_settings.joinDistance * m_settings.joinDistance &&
               (point - run.first).squaredNorm() < m_settings.longestRun * m_settings.longestRun;
    }

    static void extend(Run& run, const Eigen::Vector3f& point, std::size_t column) {
        run.last = point;
        run.lastColumn = column;
        run.points += point.cast<double>();
        run.count += 1.0;
    }

    /// Adds the label and normal of the point @p index. Those of a replaced outlier are as wrong as its
    /// range.
    void describe(Run& run, std::size_t index) const {
        if (!m_normals.empty()) run.normals += m_normals[index];
        if (!m_scan.labels.empty()) run.labels.add(m_scan.labels[index]);
    }

    /// Returns the nearest free run of the raw scan before that @p run continues; m_open.size() if there is
    /// none.
    [[nodiscard]] std::size_t nearestBefore(const Run& run, std::size_t candidate,
                                            const std::vector<bool>& taken) const {
        const Eigen::Vector3f mean = run.mean();
        std::size_t best = m_open.size();
        float bestSquared = std::numeric_limits<float>::infinity();
        for (; candidate < m_open.size() && m_open[candidate].firstColumn <= run.lastColumn; ++candidate) {
            const float squared = (m_open[candidate].last - mean).squaredNorm();
            if (taken[candidate] || squared >= bestSquared || !continues(m_open[candidate], mean)) continue;
            best = candidate;
            bestSquared = squared;
        }
        return best;
    }

    /// Returns @p before with @p run added; it continues from @p run.
    [[nodiscard]] static Run joined(const Run& before, const Run& run) {
        Run sum = run;
        sum.first = before.first;
        sum.last = run.mean();
        sum.points += before.points;
        sum.normals += before.normals;
        sum.labels += before.labels;
        sum.count += before.count;
        return sum;
    }

    void finish(const Run& run) {
        m_cloud.points.push_back(run.mean());
        m_cloud.weights.push_back(static_cast<float>(run.count));
        if (!m_normals.empty()) m_cloud.normals.push_back(run.normals.normalized());
        if (!m_scan.labels.empty()) m_cloud.labels.push_back(run.labels.commonest());
    }

    const Scan& m_scan;
    std::span<const Eigen::Vector3f> m_normals;
    const MedianFilterSettings& m_settings;
    std::vector<Run> m_open;  // runs of the last raw scan, by columns
    PointCloud m_cloud;
};

}  // namespace

std::vector<float> medianFilteredRanges(std::span<const float> ranges, double outlier) {
    std::vector<float> filtered(ranges.begin(), ranges.end());
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        if (!std::isfinite(ranges[i])) continue;
        std::array<float, 2 * HalfWindow + 1> window{};
        std::size_t count = 0;
        const std::size_t last = std::min(i + HalfWindow, ranges.size() - 1);
        for (std::size_t j = i < HalfWindow ? 0 : i - HalfWindow; j <= last; ++j) {
            if (std::isfinite(ranges[j])) window[count++] = ranges[j];
        }
        const auto middle = window.begin() + static_cast<std::ptrdiff_t>(count / 2);
        std::nth_element(window.begin(), middle, window.begin() + static_cast<std::ptrdiff_t>(count));
        if (std::abs(ranges[i] - *middle) > outlier) filtered[i] = *middle;
    }
    return filtered;
}

PointCloud medianReduced(const Scan& scan, std::span<const Eigen::Vector3f> normals,
                         const MedianFilterSettings& settings) {
    if (!scan.organised()) return pointsInRange(scan, normals, settings.minRange, settings.maxRange);
    Reduction reduction(scan, normals, settings);
    for (std::size_t row = 0; row < static_cast<std::size_t>(scan.rows); ++row) reduction.addRawScan(row);
    return reduction.result();
}

}  // namespace leitstand
