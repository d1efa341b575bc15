#include "core/io/clouds/detail/scan_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Eigenvalues>

namespace leitstand::detail {

namespace {

constexpr std::size_t FewestRows = 4, FewestColumns = 8;
constexpr std::size_t Samples = 4096;
constexpr float StartsOver = 5.0F;        // a raw scan ends at a step this many times the usual one
constexpr float NeighbouringRows = 0.2F;  // neighbouring rows differ less in direction (12 degrees)

using Points = std::vector<Eigen::Vector3f>;

/// Returns the chord between the directions to two points of a scan: about the angle [rad]; NaN: no echo.
float stepBetween(const Points& points, std::size_t a, std::size_t b) {
    const Eigen::Vector3f& p = points[a];
    const Eigen::Vector3f& q = points[b];
    return (p / p.norm() - q / q.norm()).norm();
}

/// Returns the median step over pairs @p apart, sampled evenly from the whole scan; NaN: nothing to measure.
float medianStep(const Points& points, std::size_t apart) {
    std::vector<float> steps;
    const std::size_t pairs = points.size() - apart;
    // An odd stride reaches all columns of the grid.
    const std::size_t stride = (pairs / Samples) | 1U;
    for (std::size_t i = 0; i < pairs; i += stride) {
        const float step = stepBetween(points, i, i + apart);
        if (std::isfinite(step)) steps.push_back(step);
    }
    if (steps.empty()) return std::nanf("");
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

/// Returns the normal of the plane in which the points of a row lie, seen from the scanner.
Eigen::Vector3f normalOfRow(const Points& points, std::size_t begin, std::size_t columns) {
    Eigen::Matrix3f scatter = Eigen::Matrix3f::Zero();
    for (std::size_t i = begin; i < begin + columns; ++i) {
        const float range = points[i].norm();
        if (!(range > 0.0F)) continue;
        const Eigen::Vector3f direction = points[i] / range;
        scatter += direction * direction.transpose();
    }
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f>(scatter).eigenvectors().col(0);
}

}  // namespace

std::optional<ScanGrid> detectGrid(const Points& points) {
    if (points.size() < FewestRows * FewestColumns) return std::nullopt;
    const float limit = StartsOver * medianStep(points, 1);
    if (!(limit > 0.0F)) return std::nullopt;

    std::size_t columns = 0;  // divides the index of every new start
    std::size_t starts = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (!(stepBetween(points, i - 1, i) > limit)) continue;
        columns = std::gcd(columns, i);
        if (columns < FewestColumns) return std::nullopt;
        ++starts;
    }
    if (starts == 0 || points.size() % columns != 0) return std::nullopt;
    const std::size_t rows = points.size() / columns;
    std::size_t unknown = 0;  // starts next to points without an echo
    for (std::size_t i = columns; i < points.size(); i += columns) {
        if (!std::isfinite(stepBetween(points, i - 1, i))) ++unknown;
    }
    if (rows < FewestRows || starts + unknown != rows - 1) return std::nullopt;
    if (!(medianStep(points, columns) < NeighbouringRows)) return std::nullopt;
    return ScanGrid{static_cast<int>(rows), static_cast<int>(columns)};
}

Sweep sweepOf(const Points& points, ScanGrid grid) {
    const auto columns = static_cast<std::size_t>(grid.columns);
    const auto rows = static_cast<std::size_t>(grid.rows);
    const std::size_t stride = std::max<std::size_t>(1, rows / 64);
    Eigen::Array3f along = Eigen::Array3f::Zero();
    for (std::size_t row = 0; row < rows; row += stride) {
        along += normalOfRow(points, row * columns, columns).array().square();
    }
    // The axis about which rows are turned lies in all of their planes.
    return along.y() <= along.z() ? Sweep::Tilting : Sweep::Yawing;
}

void organise(Scan& scan) {
    if (!scan.organised()) {
        const auto grid = detectGrid(scan.points);
        if (!grid) return;
        scan.rows = grid->rows;
        scan.columns = grid->columns;
    }
    scan.sweep = sweepOf(scan.points, {scan.rows, scan.columns});
}

}  // namespace leitstand::detail
