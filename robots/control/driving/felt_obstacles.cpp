#include "robots/control/driving/felt_obstacles.h"

#include <chrono>
#include <cmath>
#include <cstddef>

namespace leitstand {
namespace {

constexpr auto Memory = std::chrono::minutes(5);
constexpr double Same = 0.05;  // [m]
constexpr std::size_t Most = 200;

Eigen::Rotation2Dd turnOf(const Pose& baseInOdom) {
    const Eigen::Vector3d ahead = baseInOdom.linear().col(0);
    return Eigen::Rotation2Dd(std::atan2(ahead.y(), ahead.x()));
}

}  // namespace

void FeltObstacles::add(const Eigen::Vector2d& inBase, const Pose& baseInOdom, Time now) {
    const Eigen::Vector2d here = baseInOdom.translation().head<2>();
    const Eigen::Vector2d where = here + turnOf(baseInOdom) * inBase;
    if (!where.allFinite()) return;
    std::erase_if(m_all, [&](const One& one) { return (one.where - where).norm() < Same; });
    if (m_all.size() >= Most) m_all.erase(m_all.begin());
    m_all.push_back({where, now});
}

void FeltObstacles::addTo(VirtualScanView& view, const Pose& baseInOdom, Time now) {
    std::erase_if(m_all, [&](const One& one) { return now - one.at > Memory; });
    const Eigen::Vector2d here = baseInOdom.translation().head<2>();
    const Eigen::Rotation2Dd toBase = turnOf(baseInOdom).inverse();
    for (const One& one : m_all) view.obstacles.push_back({toBase * (one.where - here), 0.0});
}

}  // namespace leitstand
