#include "tests/simulation/mapping/building_tour.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include <fmt/format.h>

namespace leitstand::simulation::test {
namespace {

constexpr double Near = 0.9;     // of a place is there: something may stand on it [m]
constexpr double Still = 12.0;   // then it is pulled back [s]
constexpr double Moves = 0.15;   // [m]
constexpr double Pull = 3.0;     // [s]
constexpr int Tries = 3;         // for a place
constexpr double Slowest = 0.1;  // by which a way takes too long [m/s]
constexpr double Longer = 3.0;   // that a way is than the straight line
constexpr const char *Explores = "explore", *Operated = "teleoperation";

/// The place in the middle of the ring corridor that is nearest to @p room.
Eigen::Vector3d inRing(const Eigen::AlignedBox2d& ring, const Eigen::Vector3d& room) {
    Eigen::Vector2d at = room.head<2>().cwiseMax(ring.min()).cwiseMin(ring.max());
    const Eigen::Array4d off(at.x() - ring.min().x(), ring.max().x() - at.x(), at.y() - ring.min().y(),
                             ring.max().y() - at.y());
    Eigen::Index side = 0;
    off.minCoeff(&side);
    const Eigen::Vector2d& corner = side % 2 == 0 ? ring.min() : ring.max();
    at[side / 2] = corner[side / 2];
    return {at.x(), at.y(), room.z()};
}

}  // namespace

std::vector<Eigen::Vector3d> roomsInOrder(const BuildingWays& ways, int storeys) {
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
            const Eigen::Vector3d before = inRing(ways.ring, room);
            places.insert(places.end(), {before, room, before});
        }
        if (storey + 1 >= storeys) break;
        const auto& ramp = ways.ramps.at(static_cast<std::size_t>(storey));
        places.insert(places.end(), ramp.begin(), ramp.end());
        here = ramp.back();
    }
    return places;
}

BuildingTour::BuildingTour(OperatedRobot& robot, std::vector<Eigen::Vector3d> places)
    : m_robot(robot), m_places(std::move(places)) {
    m_station.bytes[0] = 1;
}

std::string BuildingTour::doing() const {
    const Eigen::Vector3d at = m_robot.state().baseInArena.translation();
    return fmt::format("at {:.1f} {:.1f} {:.1f}, {} of {} places, {} reached, {} times pulled back, {}: {}",
                       at.x(), at.y(), at.z(), m_next, m_places.size(), m_reached, m_pulls, m_mode.mode,
                       m_mode.reason);
}

void BuildingTour::ask(const std::string& mode) {
    m_robot.agent().hear(StreamRole::ModeCommand, ModeCommandSample{{}, "station 1", mode}, m_station);
}

void BuildingTour::send(double now) {
    PoseSample goal;
    goal.header.frame = m_robot.description().odomFrame;
    const Pose& base = m_robot.state().baseInArena;
    goal.poseInFrame.translation() = m_baseInOdom * (base.inverse() * *m_goal);
    m_robot.agent().hear(StreamRole::GoalPose, goal, m_station);
    ask(Explores);
    m_sent = m_movedAt = now;
    m_movedTo = base.translation();
    m_longest = 20.0 + Longer * (*m_goal - base.translation()).norm() / Slowest;
}

void BuildingTour::pullBack(double now) {
    ++m_pulls;
    ++m_tries;
    ask(Operated);
    m_robot.wish(0.0);
    m_pullUntil = now + Pull;
}

void BuildingTour::look(const std::vector<HardwareSample>& said) {
    const double now = m_robot.world().seconds();
    for (const HardwareSample& sample : said) {
        if (const auto* mode = std::get_if<ModeSample>(&sample.sample)) m_mode = *mode;
        if (const auto* odometry = std::get_if<OdometrySample>(&sample.sample))
            m_baseInOdom = odometry->baseInOdom;
    }
    const Eigen::Vector3d here = m_robot.state().baseInArena.translation();
    if ((here - m_movedTo).norm() > Moves) {
        m_movedTo = here;
        m_movedAt = now;
    }
    if (m_pullUntil) {
        const double turn = m_pulls % 2 == 0 ? 0.4 : -0.4;  // to the other side next time
        if (now < *m_pullUntil) return m_robot.wish(-0.15, now > *m_pullUntil - Pull / 2 ? turn : 0.0);
        m_robot.wish(0.0);
        m_pullUntil.reset();
        if (m_goal && m_tries < Tries) return send(now);
        m_goal.reset();
    }
    if (m_goal) {
        const bool there = (here - *m_goal).norm() < Near;
        const bool given = m_mode.mode == Operated && now - m_sent > 1.0;
        if (there) ++m_reached;
        if (there || now - m_sent > m_longest) {
            m_goal.reset();
        } else if (given || now - m_movedAt > Still) {
            return pullBack(now);
        }
    }
    if (m_goal || m_next >= m_places.size()) return;
    m_goal = m_places[m_next++];
    m_tries = 0;
    send(now);
}

}  // namespace leitstand::simulation::test
