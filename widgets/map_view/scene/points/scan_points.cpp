#include "widgets/map_view/scene/points/scan_points.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <span>
#include <utility>

#include <Eigen/Geometry>

#include "core/cloud/shades.h"

namespace leitstand {
namespace {

constexpr float CellsPerMetre = 1.0F;

std::uint64_t cellKey(const Eigen::Vector3f& point) {
    constexpr int AxisBits = 21;
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto cell = static_cast<int>(std::floor(point[axis] * CellsPerMetre)) + (1 << (AxisBits - 1));
        key = (key << AxisBits) | (static_cast<std::uint64_t>(cell) & ((1U << AxisBits) - 1U));
    }
    return key;
}

/// Consecutive points in one cell.
struct KeyedRun {
    std::uint64_t cell = 0;
    PointRun run;
};

std::vector<KeyedRun> runsOf(std::span<const Eigen::Vector3f> points) {
    std::vector<KeyedRun> runs;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const std::uint64_t cell = cellKey(points[i]);
        if (runs.empty() || runs.back().cell != cell) runs.push_back({cell, {i, i}});
        runs.back().run.end = i + 1;
    }
    return runs;
}

PointCell cellOver(const ScanPoints& points, std::size_t first, std::size_t end) {
    Eigen::AlignedBox3f box;
    for (std::size_t run = first; run < end; ++run) {
        for (std::size_t i = points.runs[run].first; i < points.runs[run].end; ++i)
            box.extend(points.points[i]);
    }
    return {box.center(), 0.5F * box.diagonal().norm(), static_cast<std::uint32_t>(first),
            static_cast<std::uint32_t>(end)};
}

void addCells(ScanPoints& points) {
    std::vector<KeyedRun> keyed = runsOf(points.points);
    std::stable_sort(keyed.begin(), keyed.end(),
                     [](const KeyedRun& a, const KeyedRun& b) { return a.cell < b.cell; });
    points.runs.reserve(keyed.size());
    for (const KeyedRun& run : keyed) points.runs.push_back(run.run);
    for (std::size_t first = 0, end = 0; first < keyed.size(); first = end) {
        while (end < keyed.size() && keyed[end].cell == keyed[first].cell) ++end;
        points.cells.push_back(cellOver(points, first, end));
    }
    points.cells.shrink_to_fit();
}

/// Returns a copy of @p scan with only the points @p kept and their labels.
ScanPtr copyOf(const Scan& scan, const std::vector<std::uint32_t>& kept, bool labelled) {
    auto copy = std::make_shared<Scan>();
    copy->points.reserve(kept.size());
    copy->labels.reserve(kept.size());
    for (const std::uint32_t i : kept) {
        copy->points.push_back(scan.points[i]);
        copy->labels.push_back(labelled ? scan.labels[i] : Label::Unlabelled);
    }
    return copy;
}

/// Returns the shades of the points @p kept of @p scan, whose points @p owner holds; null: no intensities.
std::shared_ptr<const std::vector<std::uint8_t>> drawnShades(const ScanPtr& scan, const ScanPtr& owner,
                                                             const std::vector<std::uint32_t>& kept) {
    const std::size_t count = scan->points.size();
    const bool inBytes = scan->shades.size() == count;
    if (count == 0 || (!inBytes && scan->intensities.size() != count)) return nullptr;
    if (inBytes && owner == scan) return {scan, &scan->shades};
    const std::vector<std::uint8_t> all = inBytes ? scan->shades : shadesOf(scan->intensities);
    auto some = std::make_shared<std::vector<std::uint8_t>>();
    some->reserve(kept.size());
    for (const std::uint32_t i : kept) some->push_back(all[i]);
    return some;
}

}  // namespace

std::size_t ScanPoints::memory(const Scan& scan) const {
    std::size_t bytes = cells.capacity() * sizeof(PointCell) + runs.capacity() * sizeof(PointRun);
    if (order) bytes += order->memory();
    if (owner && owner.get() != &scan) bytes += points.size_bytes() + labels.size_bytes();
    if (shades && shades.get() != &scan.shades) bytes += shades->size();
    return bytes;
}

ScanPoints drawablePoints(const ScanPtr& scan, double minRange, double maxRange) {
    const auto lowest = static_cast<float>(minRange * minRange);
    const auto highest = static_cast<float>(maxRange * maxRange);
    std::vector<std::uint32_t> drawn;
    drawn.reserve(scan->points.size());
    for (std::size_t i = 0; i < scan->points.size(); ++i) {
        const float range = scan->points[i].squaredNorm();  // NaN passes neither comparison
        if (range >= lowest && range <= highest) drawn.push_back(static_cast<std::uint32_t>(i));
    }
    ScanPoints result;
    const bool labelled = scan->labels.size() == scan->points.size();
    result.owner = labelled && drawn.size() == scan->points.size() ? scan : copyOf(*scan, drawn, labelled);
    result.points = result.owner->points;
    result.labels = result.owner->labels;
    result.shades = drawnShades(scan, result.owner, drawn);
    for (const Label label : result.labels) ++result.labelCounts[static_cast<std::size_t>(label)];
    std::iota(drawn.begin(), drawn.end(), 0U);
    std::shuffle(drawn.begin(), drawn.end(), std::minstd_rand(1));
    result.order = std::make_shared<const PointOrder>(drawn);
    addCells(result);
    return result;
}

}  // namespace leitstand
