#include "tests/simulation/mapping/building_tour.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "core/robot/robot_format.h"

namespace leitstand::simulation::test {
namespace {

constexpr double Near = 0.9;     // of a place is there: something may stand on it [m]
constexpr double Still = 12.0;   // then it is pulled back [s]
constexpr double Moves = 0.15;   // [m]
constexpr double Pull = 10.0;    // takes no longer [s]
constexpr double Wriggle = 3.0;  // of one that cannot be pulled back [s]
constexpr double Back = 1.2;     // it is pulled, the way it came [m]
constexpr double Gently = 0.2;   // [m/s]
constexpr int Tries = 3;         // for a place
constexpr double Slowest = 0.1;  // by which a way takes too long [m/s]
constexpr double Longer = 3.0;   // that a way is than the straight line
constexpr const char *Explores = "explore", *Operated = "teleoperation", *Approaches = "victim_approach";

constexpr double Approach = 90.0;  // of a body takes no longer [s]

/// Of all doors of @p room's storey, where the nearest is.
Eigen::Vector3d doorOf(const Arena& arena, const Eigen::Vector3d& room) {
    Eigen::Vector3d nearest = room;
    double distance = std::numeric_limits<double>::infinity();
    for (const Element& element : arena.elements) {
        const Eigen::Vector3d off = element.pose.translation() - room;
        if (element.kind != ElementKind::Door || std::abs(off.z()) > 1.0 || off.norm() > distance) continue;
        distance = off.norm();
        nearest = element.pose.translation();
    }
    return nearest;
}

/// The place in the middle of the ring corridor that is nearest to @p door.
Eigen::Vector3d inRing(const Eigen::AlignedBox2d& ring, const Eigen::Vector3d& door) {
    Eigen::Vector2d at = door.head<2>().cwiseMax(ring.min()).cwiseMin(ring.max());
    const Eigen::Array4d off(at.x() - ring.min().x(), ring.max().x() - at.x(), at.y() - ring.min().y(),
                             ring.max().y() - at.y());
    Eigen::Index side = 0;
    off.minCoeff(&side);
    const Eigen::Vector2d& corner = side % 2 == 0 ? ring.min() : ring.max();
    at[side / 2] = corner[side / 2];
    return {at.x(), at.y(), door.z()};
}

}  // namespace

std::vector<Eigen::Vector3d> roomsInOrder(const Building& building, int storeys) {
    const BuildingWays& ways = building.ways;
    const Eigen::Vector2d middle = ways.ring.center();
    std::vector<Eigen::Vector3d> places;
    Eigen::Vector3d here(ways.ring.min().x(), ways.ring.min().y(), 0.0);
    for (int storey = 0; storey < storeys; ++storey) {
        const double height = storey * ways.storeyHeight;
        std::vector<Eigen::Vector3d> rooms;
        for (const Eigen::Vector3d& room : ways.rooms) {
            if (std::abs(room.z() - height) < 0.5 * ways.storeyHeight) rooms.push_back(room);
        }
        const auto angle = [&](const Eigen::Vector3d& place) {
            const Eigen::Vector2d off = place.head<2>() - middle, from = here.head<2>() - middle;
            const double turn = std::atan2(off.y(), off.x()) - std::atan2(from.y(), from.x());
            return turn < -0.05 ? turn + 2.0 * std::numbers::pi : turn;
        };
        std::sort(rooms.begin(), rooms.end(),
                  [&](const auto& a, const auto& b) { return angle(a) < angle(b); });
        for (const Eigen::Vector3d& room : rooms) {
            const Eigen::Vector3d before = inRing(ways.ring, doorOf(building.arena, room));
            places.insert(places.end(), {before, room, before});
        }
        if (storey + 1 >= storeys) break;
        const auto& ramp = ways.ramps.at(static_cast<std::size_t>(storey));
        places.insert(places.end(), ramp.begin(), ramp.end());
        here = ramp.back();
    }
    return places;
}

BuildingTour::BuildingTour(TouredRobot& robot, std::vector<Eigen::Vector3d> places)
    : m_robot(robot), m_places(std::move(places)) {}

std::string BuildingTour::doing() const {
    const Eigen::Vector3d at = m_robot.baseInArena().translation();
    const ModeSample mode = m_robot.mode();
    return fmt::format("at {:.1f} {:.1f} {:.1f}, {} of {} places, {} reached, {} times pulled back, {}: {}",
                       at.x(), at.y(), at.z(), m_next, m_places.size(), m_reached, m_pulled, mode.mode,
                       mode.reason);
}

void BuildingTour::send(double now) {
    const Pose base = m_robot.baseInArena();
    m_robot.send(base.inverse() * *m_goal);
    m_robot.ask(Explores);
    m_sent = m_movedAt = now;
    m_movedTo = base.translation();
    m_longest = 20.0 + Longer * (*m_goal - base.translation()).norm() / Slowest;
}

bool BuildingTour::isPulled(const Pose& here, double now) {
    if (m_wriggles) {
        m_robot.drive(m_pulled % 2 == 0 ? Gently : -Gently, m_pulled % 4 < 2 ? 0.4 : -0.4);
        return now > *m_pulledSince + Wriggle;
    }
    while (m_trail.size() > 1 && (m_trail.back() - m_pulledFrom).norm() < Back) m_trail.pop_back();
    const Eigen::Vector3d back = here.inverse() * m_trail.back();
    const double off = std::atan2(-back.y(), -back.x());  // of its rear, to the left
    m_robot.drive(std::abs(off) < 0.6 ? -Gently : 0.0, std::clamp(1.5 * off, -0.5, 0.5));
    return back.head<2>().norm() < 0.2 || now > *m_pulledSince + Pull;
}

void BuildingTour::pullBack(double now) {
    const Pose here = m_robot.baseInArena();
    if (!m_pulledSince) {
        if (!m_robot.take()) return;
        m_pulledSince = now;
        m_pulledFrom = here.translation();
    }
    if (!isPulled(here, now)) return;
    m_robot.release();
    m_wriggles = !m_wriggles && (here.translation() - m_pulledFrom).norm() < Moves;
    m_pulledSince.reset();
    m_pulls = false;
    if (m_goal && m_tries < Tries) return send(now);
    m_goal.reset();
}

bool BuildingTour::approaches(double now) {
    const ModeSample mode = m_robot.mode();
    if (mode.mode != Approaches) {
        m_approaches.reset();
        return false;
    }
    if (!m_approaches) m_approaches = now;
    if (now - *m_approaches > Approach) return false;
    if (mode.reason == robot_format::HeatInSight) return true;
    if (m_goal && now - m_sent > 1.0) send(now);  // it waits at the body, or gave it up
    return true;
}

void BuildingTour::look() {
    const double now = m_robot.seconds();
    const Eigen::Vector3d here = m_robot.baseInArena().translation();
    if (m_trail.empty()) m_trail.push_back(here);
    if ((here - m_movedTo).norm() > Moves) {
        m_movedTo = here;
        m_movedAt = now;
        if (!m_pulls) m_trail.push_back(here);
    }
    if (m_pulls) pullBack(now);
    if (m_pulls || approaches(now)) return;
    if (m_goal) {
        const bool there = (here - *m_goal).norm() < Near;
        const bool given = m_robot.mode().mode == Operated && now - m_sent > 1.0;
        if (there) ++m_reached;
        if (there || now - m_sent > m_longest) {
            m_goal.reset();
        } else if (given || now - m_movedAt > Still) {
            ++m_pulled;
            ++m_tries;
            m_pulls = true;
            m_robot.ask(Operated);
            return;
        }
    }
    if (m_goal || m_next >= m_places.size()) return;
    m_goal = m_places[m_next++];
    m_tries = 0;
    send(now);
}

}  // namespace leitstand::simulation::test
