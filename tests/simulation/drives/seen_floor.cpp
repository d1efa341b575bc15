#include "tests/simulation/drives/seen_floor.h"

#include <algorithm>
#include <utility>

namespace leitstand::simulation::test {
namespace {

constexpr double Radius = 0.25;  ///< of the robot [m]
constexpr double Sight = 3.0;    ///< [m]
constexpr double Turn = 2.3;     ///< of the scanner [s]

}  // namespace

SeenFloor::SeenFloor(const World& world, double eye)
    : SeenFloor(world, reachableFloor(world.arena(), Radius), eye) {}

SeenFloor::SeenFloor(const World& world, ReachableFloor floor, double eye)
    : m_world(world), m_eye(eye), m_reachable(std::move(floor)), m_seen(m_reachable.reached.size(), 0) {}

void SeenFloor::look(int robot) {
    const Pose& base = m_world.state(robot).baseInArena;
    const Eigen::Vector3d head = base * Eigen::Vector3d(0.0, 0.0, m_eye);
    const bool turned = m_world.seconds() - m_lookedAt >= Turn;
    if (turned) m_lookedAt = m_world.seconds();
    const double sight = turned ? Sight : 0.05;
    const auto bound = [&](double place, double from, int count) {
        return std::clamp(static_cast<int>((place - from) / m_reachable.cell), 0, count);
    };
    const int left = bound(head.x() - sight, m_reachable.from.x(), m_reachable.columns);
    const int right = bound(head.x() + sight, m_reachable.from.x(), m_reachable.columns - 1);
    const int top = bound(head.y() + sight, m_reachable.from.y(), m_reachable.rows - 1);
    for (int row = bound(head.y() - sight, m_reachable.from.y(), m_reachable.rows); row <= top; ++row) {
        for (int column = left; column <= right; ++column) {
            const auto square = static_cast<std::size_t>(row * m_reachable.columns + column);
            if (m_reachable.reached[square] == 0 || m_seen[square] != 0) continue;
            const Eigen::Vector2d middle =
                m_reachable.from + m_reachable.cell * Eigen::Vector2d(column + 0.5, row + 0.5);
            const double away = (middle - head.head<2>()).norm();
            if (away > sight) continue;
            if (away < 0.05) {
                m_seen[square] = 1;
                continue;
            }
            // The floor may be a ramp: a ray down finds it.
            Ray down;
            down.origin = {float(middle.x()), float(middle.y()), float(base.translation().z()) + 0.45F};
            down.direction = -Eigen::Vector3f::UnitZ();
            const Hit floor = m_world.scene().cast(down, RayKind::Contact, Scene::StillOnly);
            if (!floor.there()) continue;
            Eigen::Vector3f aim = down.origin + floor.distance * down.direction;
            aim.z() += 0.02F;
            Ray ray;
            ray.origin = head.cast<float>();
            ray.direction = (aim - ray.origin).normalized();
            const Hit hit = m_world.scene().cast(ray, RayKind::Laser, robot);
            if (hit.distance >= (aim - ray.origin).norm() - 0.02F) m_seen[square] = 1;
        }
    }
}

bool SeenFloor::isSeen(int column, int row) const {
    return m_seen[static_cast<std::size_t>(row * m_reachable.columns + column)] != 0;
}

double SeenFloor::share() const {
    const auto all = std::count(m_reachable.reached.begin(), m_reachable.reached.end(), 1);
    const auto seen = std::count(m_seen.begin(), m_seen.end(), 1);
    return all == 0 ? 1.0 : static_cast<double>(seen) / static_cast<double>(all);
}

std::vector<std::string> SeenFloor::picture() const {
    std::vector<std::string> lines;
    for (int row = m_reachable.rows - 2; row >= 0; row -= 2) {
        std::string line;
        for (int column = 0; column + 1 < m_reachable.columns; column += 2) {
            const auto square = static_cast<std::size_t>(row * m_reachable.columns + column);
            const bool seen = m_seen[square] != 0 || m_seen[square + 1] != 0;
            const bool reached = m_reachable.reached[square] != 0 || m_reachable.reached[square + 1] != 0;
            line += seen ? '.' : reached ? 'o' : '#';
        }
        lines.push_back(line);
    }
    return lines;
}

}  // namespace leitstand::simulation::test
