#include "robots/control/driving/passed_heat.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "robots/control/driving/floor_memory.h"

namespace leitstand {
namespace {

constexpr double SameBody = 0.8;   // from above [m]
constexpr double BestRange = 1.5;  // to see a body from: it is whole, and its place is certain [m]
constexpr int Enough = 4;          // pictures: not a flicker past an edge
constexpr std::size_t Most = 20;   // bodies

double fromAbove(const Eigen::Vector3d& heat, const Eigen::Vector3d& place) {
    return (heat - place).head<2>().norm();
}

/// Bodies sit, lie and stand: heights only distinguish storeys.
bool isNear(const Eigen::Vector3d& heat, const Eigen::Vector3d& place, double radius) {
    return fromAbove(heat, place) < radius && FloorMemory::isSameFloor(heat.z(), place.z());
}

/// Returns the level distance; another storey counts as farther than any place on this one.
double wayTo(const Eigen::Vector3d& heat, const Eigen::Vector3d& here) {
    constexpr double OtherStorey = 1'000.0;
    return fromAbove(heat, here) + (FloorMemory::isSameFloor(heat.z(), here.z()) ? 0.0 : OtherStorey);
}

}  // namespace

void PassedHeat::see(const Eigen::Vector3d& heat, const Eigen::Vector3d& from) {
    const auto same = std::find_if(m_all.begin(), m_all.end(),
                                   [&](const One& one) { return isNear(one.heat, heat, SameBody); });
    if (same == m_all.end()) {
        if (m_all.size() < Most) m_all.push_back({heat, from, 1});
        return;
    }
    ++same->pictures;
    const double before = fromAbove(same->heat, same->from);
    if (std::abs(fromAbove(heat, from) - BestRange) > std::abs(before - BestRange)) return;
    same->heat = heat;
    same->from = from;
}

std::optional<PassedHeat::One> PassedHeat::next(const Eigen::Vector3d& here) const {
    const One* nearest = nullptr;
    for (const One& one : m_all) {
        if (one.pictures < Enough) continue;
        if (nearest == nullptr || wayTo(one.heat, here) < wayTo(nearest->heat, here)) nearest = &one;
    }
    return nearest == nullptr ? std::nullopt : std::optional(*nearest);
}

void PassedHeat::forget(const Eigen::Vector3d& place, double radius) {
    std::erase_if(m_all, [&](const One& one) { return isNear(one.heat, place, radius); });
}

}  // namespace leitstand
