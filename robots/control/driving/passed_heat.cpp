#include "robots/control/driving/passed_heat.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace leitstand {
namespace {

constexpr double SameBody = 0.8;   // from above [m]
constexpr double BestRange = 1.5;  // to see a body from: whole, and its place is sure [m]
constexpr int Enough = 4;          // pictures: not a flicker past an edge
constexpr std::size_t Most = 20;   // bodies

double offOf(const Eigen::Vector3d& heat, const Eigen::Vector2d& place) {
    return (heat.head<2>() - place).norm();
}

}  // namespace

void PassedHeat::see(const Eigen::Vector3d& heat, const Eigen::Vector2d& from) {
    const auto same = std::find_if(m_all.begin(), m_all.end(), [&](const One& one) {
        return offOf(one.heat, heat.head<2>()) < SameBody;
    });
    if (same == m_all.end()) {
        if (m_all.size() < Most) m_all.push_back({heat, from, 1});
        return;
    }
    ++same->pictures;
    if (std::abs(offOf(heat, from) - BestRange) > std::abs(offOf(same->heat, same->from) - BestRange)) return;
    same->heat = heat;
    same->from = from;
}

std::optional<PassedHeat::One> PassedHeat::next(const Eigen::Vector2d& here) const {
    const One* nearest = nullptr;
    for (const One& one : m_all) {
        if (one.pictures < Enough) continue;
        if (nearest == nullptr || offOf(one.heat, here) < offOf(nearest->heat, here)) nearest = &one;
    }
    return nearest == nullptr ? std::nullopt : std::optional(*nearest);
}

void PassedHeat::forget(const Eigen::Vector2d& place, double radius) {
    std::erase_if(m_all, [&](const One& one) { return offOf(one.heat, place) < radius; });
}

}  // namespace leitstand
