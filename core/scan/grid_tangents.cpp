#include "core/scan/grid_tangents.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace leitstand {
namespace {

constexpr float HalfWindow = 0.07F;    ///< reached to both sides where the surface goes on [m]
constexpr float LeastExtent = 0.10F;   ///< of a window, else there is no tangent [m]
constexpr float NoiseStep = 0.06F;     ///< steps of range up to this are noise, not a jump [m]
constexpr float SteepStep = 3.0F;      ///< steps of range over the beams' distance that are surely no jump
constexpr float SteepestStep = 25.0F;  ///< and the most at grazing incidence

/// Some neighbours in a line of the grid: first and last place.
struct Window {
    std::int32_t first = 0, last = -1;

    [[nodiscard]] bool empty() const { return last < first; }
};

/// What is around a point along a line of the grid.
struct Surroundings {
    Window window;  ///< of its tangent; empty where there is less than LeastExtent
    Window run;     ///< the surface without jumps; empty for a point on its own
};

/// A row or column of the grid; its vectors are reused for the next one.
class Line {
public:
    /// Takes @p count points from @p begin on, @p stride apart.
    void take(const std::vector<Eigen::Vector3f>& points, std::size_t begin, std::size_t count,
              std::size_t stride);
    [[nodiscard]] Window run(std::int32_t i) const { return m_runs[static_cast<std::size_t>(i)]; }
    /// Window around the place @p i, given the one around i - 1.
    [[nodiscard]] Window window(std::int32_t i, const Window& former) const;
    /// Tangent within a window: from the mean of its first half to that of the second; zero if it is empty.
    [[nodiscard]] Eigen::Vector3f tangent(const Window& window) const;

private:
    struct Step {
        float range = 0.0F;  ///< change of range from a point to the next one [m]
        float beams = 0.0F;  ///< distance of the two across the beams [m]
    };
    [[nodiscard]] Step step(std::size_t i) const;
    void findRuns();
    [[nodiscard]] bool apart(std::int32_t a, std::int32_t b, float distance) const {
        return (point(a) - point(b)).squaredNorm() >= distance * distance;
    }
    [[nodiscard]] const Eigen::Vector3f& point(std::int32_t i) const {
        return m_points[static_cast<std::size_t>(i)];
    }

    std::vector<Eigen::Vector3f> m_points;
    std::vector<float> m_ranges;          ///< NaN: no echo
    std::vector<Step> m_steps;            ///< from each point to the next
    std::vector<Window> m_runs;           ///< of each point: the surface without jumps around it
    std::vector<Eigen::Vector3d> m_sums;  ///< of all points before each
};

void Line::take(const std::vector<Eigen::Vector3f>& points, std::size_t begin, std::size_t count,
                std::size_t stride) {
    m_points.resize(count);
    m_ranges.resize(count);
    m_sums.resize(count + 1);
    m_sums[0].setZero();
    for (std::size_t i = 0; i < count; ++i) {
        m_points[i] = points[begin + i * stride];
        m_ranges[i] = m_points[i].norm();
        const bool echo = m_ranges[i] > 0.0F && std::isfinite(m_ranges[i]);
        if (!echo) m_ranges[i] = std::numeric_limits<float>::quiet_NaN();
        m_sums[i + 1] = m_sums[i];
        if (echo) m_sums[i + 1] += m_points[i].cast<double>();
    }
    findRuns();
}

Line::Step Line::step(std::size_t i) const {
    const float range = m_ranges[i + 1] - m_ranges[i];
    const float squared = (m_points[i + 1] - m_points[i]).squaredNorm() - range * range;
    return {range, std::sqrt(std::max(squared, 0.0F))};
}

void Line::findRuns() {
    const std::size_t count = m_points.size();
    m_steps.resize(count);
    for (std::size_t i = 0; i + 1 < count; ++i) m_steps[i] = step(i);
    // At grazing incidence the range changes much from beam to beam, but evenly; at a jump it does so once.
    const auto even = [&](std::size_t i, std::size_t beside) {
        const float a = m_steps[i].range, b = m_steps[beside].range;
        return a * b > 0.0F && std::abs(a) < 2.0F * std::abs(b) && std::abs(b) < 2.0F * std::abs(a);
    };
    const auto joined = [&](std::size_t i) {
        const float change = std::abs(m_steps[i].range);  // NaN without echo: no comparison holds
        if (change <= std::max(NoiseStep, SteepStep * m_steps[i].beams)) return true;
        if (!(change <= SteepestStep * m_steps[i].beams)) return false;
        return (i > 0 && even(i, i - 1)) || (i + 2 < count && even(i, i + 1));
    };
    m_runs.assign(count, Window{});
    for (std::size_t first = 0; first < count;) {
        std::size_t last = first;
        while (last + 1 < count && joined(last)) ++last;
        const Window run{static_cast<std::int32_t>(first), static_cast<std::int32_t>(last)};
        if (last > first) std::fill(m_runs.begin() + run.first, m_runs.begin() + run.last + 1, run);
        first = last + 1;
    }
}

Window Line::window(std::int32_t i, const Window& former) const {
    const Window run = this->run(i);
    if (run.empty()) return run;
    // Windows change little from point to point: begin with the former one.
    Window result{std::clamp(former.first, run.first, i), std::clamp(former.last, i, run.last)};
    while (result.first > run.first && !apart(result.first, i, HalfWindow)) --result.first;
    while (result.first < i && apart(result.first + 1, i, HalfWindow)) ++result.first;
    while (result.last > i && apart(result.last - 1, i, HalfWindow)) --result.last;
    while (result.last < run.last && !apart(result.last, i, HalfWindow)) ++result.last;
    // Beside a jump the other side alone has to make up the extent.
    while (result.last < run.last && !apart(result.first, result.last, LeastExtent)) ++result.last;
    while (result.first > run.first && !apart(result.first, result.last, LeastExtent)) --result.first;
    return apart(result.first, result.last, LeastExtent) ? result : Window{};
}

Eigen::Vector3f Line::tangent(const Window& window) const {
    if (window.empty()) return Eigen::Vector3f::Zero();
    const std::int32_t half = (window.last - window.first + 1) / 2;
    const auto sum = [&](std::int32_t from, std::int32_t to) {
        return m_sums[static_cast<std::size_t>(to)] - m_sums[static_cast<std::size_t>(from)];
    };
    const Eigen::Vector3d difference =
        sum(window.last + 1 - half, window.last + 1) - sum(window.first, window.first + half);
    return (difference / half).cast<float>();
}

/// All lines of one direction of a grid: @p count lines of @p length points, @p step from point to point and
/// @p pitch from line to line.
struct Lines {
    std::size_t count, length, step, pitch;
};

/// Tangents along @p lines, and what they were taken from.
std::vector<Surroundings> fit(const std::vector<Eigen::Vector3f>& points, const Lines& lines,
                              std::vector<Eigen::Vector3f>& tangents) {
    tangents.resize(points.size());
    std::vector<Surroundings> result(points.size());
    Line line;
    for (std::size_t l = 0; l < lines.count; ++l) {
        line.take(points, l * lines.pitch, lines.length, lines.step);
        Window window{0, 0};
        for (std::size_t i = 0; i < lines.length; ++i) {
            const auto place = static_cast<std::int32_t>(i);
            const std::size_t at = l * lines.pitch + i * lines.step;
            const Window found = line.window(place, window);
            window = found.empty() ? Window{place, place} : found;
            result[at] = {found, line.run(place)};
            tangents[at] = line.tangent(found);
        }
    }
    return result;
}

/// Sums of vectors along a line of the grid.
class Sums {
public:
    void take(const std::vector<Eigen::Vector3f>& vectors, std::size_t begin, const Lines& lines) {
        m_sums.resize(lines.length + 1);
        m_sums[0].setZero();
        for (std::size_t i = 0; i < lines.length; ++i) {
            m_sums[i + 1] = m_sums[i] + vectors[begin + i * lines.step];
        }
    }
    [[nodiscard]] Eigen::Vector3f of(const Window& window) const {
        return m_sums[static_cast<std::size_t>(window.last + 1)] -
               m_sums[static_cast<std::size_t>(window.first)];
    }

private:
    std::vector<Eigen::Vector3f> m_sums;
};

/// Averages the tangents of the other direction over the windows along @p lines.
void smooth(std::vector<Eigen::Vector3f>& tangents, const Lines& lines,
            const std::vector<Surroundings>& surroundings) {
    Sums sums;
    for (std::size_t l = 0; l < lines.count; ++l) {
        sums.take(tangents, l * lines.pitch, lines);
        for (std::size_t i = 0; i < lines.length; ++i) {
            const std::size_t at = l * lines.pitch + i * lines.step;
            if (!surroundings[at].window.empty()) tangents[at] = sums.of(surroundings[at].window);
        }
    }
}

/// Where the axis of the scanner meets a surface, the rows cross in one place and a column is but a spot:
/// there the rows themselves give both directions, the second one from half a column away.
void bridgePoles(GridTangents& tangents, const Lines& columns,
                 const std::vector<Surroundings>& surroundings) {
    constexpr std::int32_t LeastRows = 16;
    Sums rows;
    for (std::size_t c = 0; c < columns.count; ++c) {
        rows.take(tangents.alongRows, c * columns.pitch, columns);
        for (std::size_t i = 0; i < columns.length; ++i) {
            const std::size_t at = c * columns.pitch + i * columns.step;
            const auto& [window, run] = surroundings[at];
            const std::int32_t size = run.last - run.first + 1;
            if (!window.empty() || size < LeastRows) continue;
            const auto around = [&](std::int32_t place) {
                return rows.of({std::max(run.first, place - size / 8), std::min(run.last, place + size / 8)});
            };
            const auto place = static_cast<std::int32_t>(i);
            tangents.alongRows[at] = around(place);
            tangents.alongColumns[at] =
                around(place + size / 2 <= run.last ? place + size / 2 : place - size / 2);
        }
    }
}

}  // namespace

Eigen::Vector3f GridTangents::normal(std::size_t i, const Eigen::Vector3f& point) const {
    constexpr float LeastSine = 0.15F;  // of the angle between two directions that tell a plane
    const Eigen::Vector3f &a = alongRows[i], &b = alongColumns[i];
    const Eigen::Vector3f cross = a.cross(b);
    const float squared = cross.squaredNorm();
    if (!(squared > LeastSine * LeastSine * a.squaredNorm() * b.squaredNorm()))
        return Eigen::Vector3f::Zero();
    return cross * ((cross.dot(point) > 0.0F ? -1.0F : 1.0F) / std::sqrt(squared));
}

GridTangents gridTangents(const Scan& scan) {
    const auto height = static_cast<std::size_t>(scan.rows), width = static_cast<std::size_t>(scan.columns);
    assert(scan.organised() && scan.points.size() == height * width);
    const Lines rows{height, width, 1, width}, columns{width, height, width, 1};
    GridTangents result;
    const auto aroundInRow = fit(scan.points, rows, result.alongRows);
    const auto aroundInColumn = fit(scan.points, columns, result.alongColumns);
    smooth(result.alongColumns, rows, aroundInRow);
    smooth(result.alongRows, columns, aroundInColumn);
    bridgePoles(result, columns, aroundInColumn);
    return result;
}

}  // namespace leitstand
