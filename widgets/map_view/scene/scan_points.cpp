#include "widgets/map_view/scene/scan_points.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>

#include <Eigen/Geometry>

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

PointCell cellOver(const ScanPoints& points, std::size_t first, std::size_t end) {
    Eigen::AlignedBox3f box;
    for (std::size_t i = first; i < end; ++i) box.extend(points.points[points.cellMembers[i]]);
    return {box.center(), 0.5F * box.diagonal().norm(), first, end};
}

void addCells(ScanPoints& points) {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed;
    keyed.reserve(points.points.size());
    for (const Eigen::Vector3f& point : points.points) {
        keyed.emplace_back(cellKey(point), static_cast<std::uint32_t>(keyed.size()));
    }
    std::sort(keyed.begin(), keyed.end());
    points.cellMembers.reserve(keyed.size());
    for (const auto& [key, index] : keyed) points.cellMembers.push_back(index);
    for (std::size_t first = 0, end = 0; first < keyed.size(); first = end) {
        while (end < keyed.size() && keyed[end].first == keyed[first].first) ++end;
        points.cells.push_back(cellOver(points, first, end));
    }
}

}  // namespace

ScanPoints drawablePoints(const Scan& scan, double minRange, double maxRange) {
    const auto lowest = static_cast<float>(minRange * minRange);
    const auto highest = static_cast<float>(maxRange * maxRange);
    std::vector<std::uint32_t> order;
    order.reserve(scan.points.size());
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        const float range = scan.points[i].squaredNorm();  // NaN passes neither comparison
        if (range >= lowest && range <= highest) order.push_back(static_cast<std::uint32_t>(i));
    }
    std::shuffle(order.begin(), order.end(), std::minstd_rand(1));

    ScanPoints result;
    result.points.reserve(order.size());
    result.labels.reserve(order.size());
    const bool labelled = scan.labels.size() == scan.points.size();
    for (const std::uint32_t i : order) {
        result.points.push_back(scan.points[i]);
        result.labels.push_back(labelled ? scan.labels[i] : Label::Unlabelled);
        ++result.labelCounts[static_cast<std::size_t>(result.labels.back())];
    }
    addCells(result);
    return result;
}

}  // namespace leitstand
