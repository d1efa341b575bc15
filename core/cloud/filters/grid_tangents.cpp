#include "core/cloud/filters/grid_tangents.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/base/parallel.h"

namespace leitstand {
namespace {

constexpr float HalfWindow = 0.07F;    ///< reach of a window to each side, where the surface goes on [m]
constexpr float LeastExtent = 0.10F;   ///< least extent of a window that gives a tangent [m]
constexpr float NoiseStep = 0.06F;     ///< steps of range up to this are noise, not a jump [m]
constexpr float SteepStep = 3.0F;      ///< range step over the beams' distance that is surely no jump
constexpr float SteepestStep = 25.0F;  ///< the most at grazing incidence
constexpr std::int32_t LongestHalf = 30'000;  ///< of a window [points]
constexpr std::int32_t LeastSpot = 16;        ///< least number of points too close together to give a tangent
constexpr std::size_t LineGrain = 32;         ///< lines that a thread takes at once

/// Places in a line of the grid: first and last.
struct Range {
    std::int32_t first = 0, last = 0;

    [[nodiscard]] std::int32_t size() const { return last - first + 1; }
};

/// A row or column of the grid; its vectors are reused for the next line.
class Line {
public:
    /// Takes @p count points from @p begin on, @p stride apart.
    void take(const std::vector<Eigen::Vector3f>& points, std::size_t begin, std::size_t count,
              std::size_t stride);
    /// The surfaces without jumps along the line, each of two points or more.
    [[nodiscard]] const std::vector<Range>& runs() const { return m_runs; }
    /// Neighbours of the place @p i in its @p run, given those of i - 1.
    [[nodiscard]] Range window(std::int32_t i, const Range& run, const Range& former) const;
    /// Whether the ends of a window are LeastExtent apart.
    [[nodiscard]] bool extended(const Range& window) const {
        return squaredDistance(window.first, window.last) >= LeastExtent * LeastExtent;
    }
    /// Tangent within a window: from the mean of its first half to that of the second.
    [[nodiscard]] Eigen::Vector3f tangent(const Range& window) const;

private:
    struct Step {
        float range;  ///< change of range from a point to the next one; NaN without echo [m]
        float beams;  ///< distance of the two across the beams [m]
    };
    [[nodiscard]] bool joined(std::size_t i) const;
    [[nodiscard]] bool even(std::size_t i, std::size_t beside) const;
    [[nodiscard]] float squaredDistance(std::int32_t a, std::int32_t b) const {
        return (m_points[static_cast<std::size_t>(a)] - m_points[static_cast<std::size_t>(b)]).squaredNorm();
    }

    // Vectors of four, the last one 0, fit the processor's.
    std::vector<Eigen::Vector4f> m_points;
    std::vector<Eigen::Vector4d> m_sums;  ///< sums of all points with an echo before each
    std::vector<float> m_ranges;          ///< NaN: no echo
    std::vector<Step> m_steps;            ///< from each point to the next
    std::vector<Range> m_runs;
};

void Line::take(const std::vector<Eigen::Vector3f>& points, std::size_t begin, std::size_t count,
                std::size_t stride) {
    m_points.resize(count);
    m_ranges.resize(count);
    m_sums.resize(count + 1);
    m_steps.resize(count);
    // Scalars and running sums: to read back at once what was just written would stall.
    double x = 0.0, y = 0.0, z = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const Eigen::Vector3f& point = points[begin + i * stride];
        m_points[i] << point, 0.0F;
        m_sums[i] << x, y, z, 0.0;
        const float squaredRange = point.squaredNorm();
        m_ranges[i] = std::numeric_limits<float>::quiet_NaN();
        if (!(squaredRange > 0.0F && squaredRange < std::numeric_limits<float>::infinity())) continue;
        m_ranges[i] = std::sqrt(squaredRange);
        x += point.x();
        y += point.y();
        z += point.z();
    }
    m_sums[count] << x, y, z, 0.0;
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const float range = m_ranges[i + 1] - m_ranges[i];
        const float squared = (m_points[i + 1] - m_points[i]).squaredNorm() - range * range;
        m_steps[i] = {range, std::sqrt(std::max(squared, 0.0F))};
    }
    m_runs.clear();
    for (std::size_t first = 0, last = 0; first < count; first = ++last) {
        while (last + 1 < count && joined(last)) ++last;
        if (last > first)
            m_runs.push_back({static_cast<std::int32_t>(first), static_cast<std::int32_t>(last)});
    }
}

bool Line::joined(std::size_t i) const {
    const float change = std::abs(m_steps[i].range), beams = m_steps[i].beams;
    // Without an echo the change is NaN, and no comparison holds.
    if (change <= std::max(NoiseStep, SteepStep * beams)) return true;
    if (!(change <= SteepestStep * beams)) return false;
    return (i > 0 && even(i, i - 1)) || (i + 2 < m_points.size() && even(i, i + 1));
}

bool Line::even(std::size_t i, std::size_t beside) const {
    // At grazing incidence the range changes much from beam to beam, but evenly; at a jump it does so once.
    const float a = m_steps[i].range, b = m_steps[beside].range;
    return a * b > 0.0F && std::abs(a) < 2.0F * std::abs(b) && std::abs(b) < 2.0F * std::abs(a);
}

Range Line::window(std::int32_t i, const Range& run, const Range& former) const {
    constexpr float Reach = HalfWindow * HalfWindow;
    // Windows change little from point to point: begin with the former one.
    std::int32_t first = std::clamp(former.first, std::max(run.first, i - LongestHalf), i);
    std::int32_t last = std::clamp(former.last, i, run.last);
    while (first < i && squaredDistance(first + 1, i) >= Reach) ++first;
    while (first > run.first && squaredDistance(first, i) < Reach) --first;
    while (last > i && squaredDistance(last - 1, i) >= Reach) --last;
    while (last < run.last && squaredDistance(last, i) < Reach) ++last;
    // Beside a jump, the other side alone makes up the extent.
    if (first == run.first || last == run.last) {
        while (last < run.last && !extended({first, last})) ++last;
        while (first > run.first && !extended({first, last})) --first;
    }
    return {std::max(first, i - LongestHalf), std::min(last, i + LongestHalf)};
}

Eigen::Vector3f Line::tangent(const Range& window) const {
    const std::int32_t half = window.size() / 2;
    const auto sum = [&](std::int32_t from, std::int32_t to) {
        return m_sums[static_cast<std::size_t>(to)] - m_sums[static_cast<std::size_t>(from)];
    };
    const Eigen::Vector4d difference =
        sum(window.last + 1 - half, window.last + 1) - sum(window.first, window.first + half);
    return (difference * (1.0 / half)).cast<float>().head<3>();
}

/// All lines of one direction of a grid: @p count lines of @p length points, @p step from point to point and
/// @p pitch from line to line.
struct Lines {
    std::size_t count, length, step, pitch;

    [[nodiscard]] std::size_t index(std::size_t line, std::int32_t place) const {
        return line * pitch + static_cast<std::size_t>(place) * step;
    }
};

/// Number of neighbours of a point on both sides along a line that its tangent was fitted to; none: no
/// tangent.
struct Neighbours {
    std::uint16_t before = 0, after = 0;
};

/// Many points of one line of the grid within less than LeastExtent.
struct Spot {
    std::size_t line;
    Range places;
};

/// Tangents along lines, and the points that they were fitted to.
struct Fit {
    std::vector<Eigen::Vector3f> tangents;
    std::vector<Neighbours> neighbours;
    std::vector<Spot> spots;
};

/// Fits the tangents of the lines from @p first up to @p last, and collects their spots separately.
void fitLines(const std::vector<Eigen::Vector3f>& points, const Lines& lines, std::size_t first,
              std::size_t last, Fit& result, std::vector<Spot>& spots) {
    Line line;
    for (std::size_t l = first; l < last; ++l) {
        line.take(points, l * lines.pitch, lines.length, lines.step);
        for (const Range& run : line.runs()) {
            Range window{run.first, run.first};
            bool extended = false;
            for (std::int32_t i = run.first; i <= run.last; ++i) {
                // Windows change little from point to point: three of four only move on.
                const bool moves = extended && i % 4 != 0 && window.first + 1 < i && window.last >= i &&
                                   window.last < run.last;
                if (moves) {
                    ++window.first;
                    ++window.last;
                } else {
                    window = line.window(i, run, window);
                    extended = line.extended(window);
                }
                if (!extended) continue;
                const std::size_t at = lines.index(l, i);
                result.tangents[at] = line.tangent(window);
                result.neighbours[at] = {static_cast<std::uint16_t>(i - window.first),
                                         static_cast<std::uint16_t>(window.last - i)};
            }
            if (run.size() >= LeastSpot && !extended) spots.push_back({l, run});
        }
    }
}

Fit fit(const std::vector<Eigen::Vector3f>& points, const Lines& lines, int threads) {
    Fit result;
    result.tangents.resize(points.size(), Eigen::Vector3f::Zero());
    result.neighbours.resize(points.size());
    std::vector<std::vector<Spot>> spots(lines.count / LineGrain + 1);
    parallelFor(lines.count, LineGrain, threads, [&](std::size_t first, std::size_t last) {
        fitLines(points, lines, first, last, result, spots[first / LineGrain]);
    });
    for (const std::vector<Spot>& found : spots) {
        result.spots.insert(result.spots.end(), found.begin(), found.end());
    }
    return result;
}

/// Sums of vectors along a line of the grid.
class Sums {
public:
    void take(const std::vector<Eigen::Vector3f>& vectors, std::size_t line, const Lines& lines) {
        m_sums.resize(lines.length + 1);
        float x = 0.0F, y = 0.0F, z = 0.0F;
        for (std::size_t i = 0; i < lines.length; ++i) {
            m_sums[i] << x, y, z, 0.0F;
            const Eigen::Vector3f& vector = vectors[line * lines.pitch + i * lines.step];
            x += vector.x();
            y += vector.y();
            z += vector.z();
        }
        m_sums[lines.length] << x, y, z, 0.0F;
    }
    [[nodiscard]] Eigen::Vector3f of(const Range& range) const {
        return (m_sums[static_cast<std::size_t>(range.last + 1)] -
                m_sums[static_cast<std::size_t>(range.first)])
            .head<3>();
    }

private:
    std::vector<Eigen::Vector4f> m_sums;
};

/// Averages the tangents of the other direction over the neighbours along @p lines.
void smooth(std::vector<Eigen::Vector3f>& tangents, const Lines& lines,
            const std::vector<Neighbours>& neighbours, int threads) {
    const auto length = static_cast<std::int32_t>(lines.length);
    parallelFor(lines.count, LineGrain, threads, [&](std::size_t first, std::size_t last) {
        Sums sums;
        for (std::size_t l = first; l < last; ++l) {
            sums.take(tangents, l, lines);
            for (std::int32_t i = 0; i < length; ++i) {
                const std::size_t at = lines.index(l, i);
                const auto [before, after] = neighbours[at];
                if (before + after > 0) tangents[at] = sums.of({i - before, i + after});
            }
        }
    });
}

/// Where the scanner's axis meets a surface, the rows cross in one place and a column is only a spot. There
/// the rows give both directions, the second one from half a column away.
void bridgePoles(GridTangents& tangents, const Lines& columns, const std::vector<Spot>& spots) {
    Sums rows;
    for (const auto& [column, places] : spots) {
        rows.take(tangents.alongRows, column, columns);
        const std::int32_t half = places.size() / 2, near = places.size() / 8;
        const auto around = [&, run = places](std::int32_t i) {
            return rows.of({std::max(run.first, i - near), std::min(run.last, i + near)});
        };
        for (std::int32_t i = places.first; i <= places.last; ++i) {
            const std::size_t at = columns.index(column, i);
            tangents.alongRows[at] = around(i);
            tangents.alongColumns[at] = around(i + half <= places.last ? i + half : i - half);
        }
    }
}

}  // namespace

Eigen::Vector3f GridTangents::normal(std::size_t i, const Eigen::Vector3f& point) const {
    constexpr float LeastSine = 0.15F;  // of the angle between two directions that span a plane
    const Eigen::Vector3f &a = alongRows[i], &b = alongColumns[i];
    const Eigen::Vector3f cross = a.cross(b);
    const float squared = cross.squaredNorm();
    if (!(squared > LeastSine * LeastSine * a.squaredNorm() * b.squaredNorm()))
        return Eigen::Vector3f::Zero();
    return cross * ((cross.dot(point) > 0.0F ? -1.0F : 1.0F) / std::sqrt(squared));
}

GridTangents gridTangents(const Scan& scan, int threads) {
    const auto height = static_cast<std::size_t>(scan.rows), width = static_cast<std::size_t>(scan.columns);
    assert(scan.organised() && scan.points.size() == height * width);
    const Lines rows{height, width, 1, width}, columns{width, height, width, 1};
    Fit alongRows = fit(scan.points, rows, threads), alongColumns = fit(scan.points, columns, threads);
    smooth(alongColumns.tangents, rows, alongRows.neighbours, threads);
    smooth(alongRows.tangents, columns, alongColumns.neighbours, threads);
    GridTangents result{std::move(alongRows.tangents), std::move(alongColumns.tangents)};
    bridgePoles(result, columns, alongColumns.spots);
    return result;
}

}  // namespace leitstand
