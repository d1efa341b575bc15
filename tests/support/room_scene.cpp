#include "tests/support/room_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace leitstand::test {
namespace {

/// Where a line is inside a box, and through which axes it enters and leaves.
struct Crossing {
    double enter = -std::numeric_limits<double>::infinity();
    double leave = std::numeric_limits<double>::infinity();
    int enterAxis = 0, leaveAxis = 0;
};

Crossing crossing(const Box& box, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
    Crossing result;
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0.0) {
            if (origin[axis] < box.low[axis] || origin[axis] > box.high[axis]) result.leave = -1.0;
            continue;
        }
        double first = (box.low[axis] - origin[axis]) / direction[axis];
        double second = (box.high[axis] - origin[axis]) / direction[axis];
        if (first > second) std::swap(first, second);
        if (first > result.enter) result.enter = first, result.enterAxis = axis;
        if (second < result.leave) result.leave = second, result.leaveAxis = axis;
    }
    return result;
}

double distance(const Box& box, const Eigen::Vector3d& point) {
    return (point - point.cwiseMax(box.low).cwiseMin(box.high)).norm();
}

/// The normal that opposes @p direction along @p axis.
Eigen::Vector3d facing(int axis, const Eigen::Vector3d& direction) {
    return Eigen::Vector3d::Unit(axis) * (direction[axis] > 0.0 ? -1.0 : 1.0);
}

/// Legs and top of a table of height 0.75 m over the rectangle @p low to @p high.
void addTable(std::vector<Box>& bodies, const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
    bodies.push_back({{low.x(), low.y(), 0.71}, {high.x(), high.y(), 0.75}});
    const double thick = 0.06;
    for (const double x : {low.x(), high.x() - thick}) {
        for (const double y : {low.y(), high.y() - thick}) {
            bodies.push_back({{x, y, 0.0}, {x + thick, y + thick, 0.71}});
        }
    }
}

}  // namespace

RoomScene::RoomScene(double length, double width, double height, bool furnished, bool openEnds)
    : m_room{{-length / 2, -width / 2, 0.0}, {length / 2, width / 2, height}}, m_openEnds(openEnds) {
    if (!furnished) return;
    const double x = length / 2, y = width / 2;
    m_bodies.push_back({{0.55 * x, 0.45 * y, 0.0}, {0.55 * x + 0.4, 0.45 * y + 0.4, height}});    // pillar
    m_bodies.push_back({{-0.65 * x, -0.7 * y, 0.0}, {-0.65 * x + 0.3, -0.7 * y + 0.5, height}});  // pillar
    m_bodies.push_back({{0.1 * x, y - 0.35, 0.0}, {0.1 * x + 1.2, y, 0.9}});  // shelf: its lower part
    m_bodies.push_back({{0.1 * x, y - 0.35, 1.4}, {0.1 * x + 1.2, y, 1.8}});  // and its upper part
    addTable(m_bodies, {0.5 * x, -0.8 * y}, {0.5 * x + 1.4, -0.8 * y + 0.8});
    m_bodies.push_back({{-0.4 * x, 0.2 * y, height - 0.45}, {-0.4 * x + 1.4, 0.2 * y + 0.5, height - 0.3}});
}

const Box& RoomScene::box(int body) const {
    return body < 0 ? m_room : m_bodies[static_cast<std::size_t>(body)];
}

std::optional<Hit> RoomScene::cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const {
    const Crossing room = crossing(m_room, origin, direction);
    Hit hit;
    hit.range = room.leave;
    hit.normal = facing(room.leaveAxis, direction);
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        const Crossing body = crossing(m_bodies[i], origin, direction);
        if (body.enter > body.leave || body.enter <= 0.0 || body.enter >= hit.range) continue;
        hit.range = body.enter;
        hit.normal = facing(body.enterAxis, direction);
        hit.body = static_cast<int>(i);
    }
    if (m_openEnds && hit.body < 0 && room.leaveAxis == 0) return std::nullopt;
    hit.point = origin + hit.range * direction;
    return hit;
}

double RoomScene::edgeDistance(const Hit& hit) const {
    const Box& face = box(hit.body);
    double result = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (hit.normal[axis] != 0.0) continue;
        result = std::min({result, hit.point[axis] - face.low[axis], face.high[axis] - hit.point[axis]});
    }
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        if (static_cast<int>(i) != hit.body) result = std::min(result, distance(m_bodies[i], hit.point));
    }
    return std::max(result, 0.0);
}

bool RoomScene::buried(const Hit& hit) const {
    constexpr double Touching = 1e-6;
    if (hit.body >= 0) {
        const Eigen::Vector3d inFront = hit.point + 2 * Touching * hit.normal;
        if ((inFront.array() < m_room.low.array()).any() || (inFront.array() > m_room.high.array()).any()) {
            return true;
        }
    }
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        if (static_cast<int>(i) != hit.body && distance(m_bodies[i], hit.point) < Touching) return true;
    }
    return false;
}

Hit RoomScene::sample(std::mt19937& random) const {
    // Six faces a box; the room's normals point inwards, those of bodies outwards.
    std::vector<double> areas;
    for (int body = -1; body < static_cast<int>(m_bodies.size()); ++body) {
        const Eigen::Vector3d size = box(body).high - box(body).low;
        for (int axis = 0; axis < 3; ++axis) {
            const double area = size[(axis + 1) % 3] * size[(axis + 2) % 3];
            areas.insert(areas.end(), 2, area);
        }
    }
    std::discrete_distribution<int> faces(areas.begin(), areas.end());
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (;;) {
        const int face = faces(random);
        Hit hit;
        hit.body = face / 6 - 1;
        const int axis = face % 6 / 2;
        const bool atHigh = face % 2 == 1;
        const Box& on = box(hit.body);
        for (int i = 0; i < 3; ++i) hit.point[i] = on.low[i] + unit(random) * (on.high[i] - on.low[i]);
        hit.point[axis] = atHigh ? on.high[axis] : on.low[axis];
        hit.normal = Eigen::Vector3d::Unit(axis) * (atHigh == (hit.body >= 0) ? 1.0 : -1.0);
        if (!buried(hit)) return hit;
    }
}

Label trueLabel(const Eigen::Vector3d& normal) {
    if (normal.z() > 0.5) return Label::Floor;
    return normal.z() < -0.5 ? Label::Ceiling : Label::Wall;
}

}  // namespace leitstand::test
