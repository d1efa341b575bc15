#include "core/perception/surroundings/near_obstacles.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>

#include "core/base/pose.h"

namespace leitstand {
namespace {

constexpr auto Memory = std::chrono::seconds(30);
constexpr double Same = 0.03;          // [m]
constexpr double Far = 2.0;            // farther obstacles are seen again before they matter [m]
constexpr double Beam = degrees(1.2);  // half the width that a raw scan looks through
constexpr std::size_t Most = 1'000;

}  // namespace

void NearObstacles::add(const One& one) {
    const auto same = std::find_if(m_all.begin(), m_all.end(), [&](const One& other) {
        return (other.where - one.where).squaredNorm() < Same * Same;
    });
    if (same != m_all.end()) {
        *same = one;
    } else if (m_all.size() < Most) {
        m_all.push_back(one);
    } else {
        *std::min_element(m_all.begin(), m_all.end(),
                          [](const One& a, const One& b) { return a.at < b.at; }) = one;
    }
}

void NearObstacles::lookThrough(const Eigen::Vector2d& origin, double heading, double from, double to,
                                Time at) {
    const Eigen::Vector2d along(std::cos(heading), std::sin(heading));
    std::erase_if(m_all, [&](const One& one) {
        const Eigen::Vector2d away = one.where - origin;
        const double distance = away.norm();
        if (at - one.at > Memory || distance > Far) return true;
        const double aside = std::abs(along.x() * away.y() - along.y() * away.x());
        const bool inBeam = along.dot(away) > 0.0 && aside < std::sin(Beam) * distance;
        return inBeam && one.at < at && distance > from && distance < to;
    });
}

void NearObstacles::forgetMixed(const OwnBodyMask& mask, double within) {
    std::erase_if(m_all, [&](const One& one) {
        return one.shot.norm() < within && !one.shot.isZero() && mask.isNear(one.shot, one.at);
    });
}

}  // namespace leitstand
