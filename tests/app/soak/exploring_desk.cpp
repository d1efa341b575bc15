#include "tests/app/soak/exploring_desk.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/event/motion_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/mission/state/mission_state.h"
#include "core/mission/state/robot_state.h"
#include "tests/app/robots/robot_process.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

constexpr std::chrono::seconds Again(15);  ///< until a robot is asked again
constexpr std::chrono::seconds Still(20);  ///< then it has nothing left to do
constexpr double Step = 0.1;               ///< [m, rad] that is a move
constexpr double Apart = 1.0;              ///< places that are remembered [m]
constexpr std::size_t TriesABack = 3;      ///< goals that a robot did not go to, until it is pulled back
constexpr std::chrono::seconds Pull(4);
constexpr double Gently = 0.1;  ///< [m/s]
constexpr const char* Explores = "explore";

/// A shipped robot of which nothing is heard but what tells whether it is there and what it does.
RobotDescription plainRobot(const std::string& name) {
    RobotDescription robot = shippedRobot(name);
    std::erase_if(robot.streams, [](const StreamDescription& stream) {
        const auto role = stream.role;
        return !isCommand(role) && role != StreamRole::Odometry && role != StreamRole::Mode &&
               role != StreamRole::StopState && role != StreamRole::Pong;
    });
    return robot;
}

/// What @p robot said of itself; null before it said a mode and where it is.
const RobotState* stateOf(const MissionState& mission, const std::string& robot) {
    const auto reported = mission.robots.find(robot);
    const bool known =
        reported != mission.robots.end() && reported->second->mode && reported->second->odometry;
    return known ? &*reported->second : nullptr;
}

double distance(const Pose& one, const Pose& other) {
    return (one.translation() - other.translation()).norm();
}

}  // namespace

ExploringDesk::ExploringDesk(const TestDomain& domain, const std::vector<std::string>& robots) {
    StationSettings settings;
    settings.domain.domain = domain.number();
    settings.domain.interfaces = {"lo"};
    settings.mission.folder = m_folder / "mission";
    settings.mission.title = "Explorers' desk";
    for (const std::string& robot : robots) {
        settings.mission.robots.push_back(plainRobot(robot));
        m_walks.push_back({robot});
    }
    settings.memory = m_folder / "station.yaml";
    m_station = must(Station::open(settings));
}

void ExploringDesk::look() {
    const auto now = std::chrono::steady_clock::now();
    const auto mission = m_station->mission();
    for (Walk& walk : m_walks) {
        const RobotState* reported = stateOf(*mission, walk.robot);
        if (!reported) continue;
        follow(walk, reported->odometry->sample.baseInOdom, now);
        const bool still = now - walk.moved > Still;
        if ((reported->mode->sample.mode == Explores && !still) || now - walk.asked < Again) continue;
        m_station->requestGrant(walk.robot);
        if (!m_station->robot(walk.robot).grant.mine) continue;
        if (still) sendOn(walk);
        (void)m_station->setMode(walk.robot, Explores);
        walk.asked = walk.moved = now;
    }
}

void ExploringDesk::follow(Walk& walk, const Pose& baseInOdom, Time now) {
    if (walk.places.empty()) {
        walk.here = baseInOdom;
        walk.moved = now;
    }
    const double moved = distance(walk.here, baseInOdom);
    if (moved > Step || angleBetween(walk.here, baseInOdom) > Step) {
        walk.length += moved;
        walk.since += moved;
        if (walk.since > Apart) walk.tries = 0;
        walk.here = baseInOdom;
        walk.moved = now;
    }
    const auto near = [&](const Pose& place) { return distance(place, baseInOdom) < Apart; };
    if (std::none_of(walk.places.begin(), walk.places.end(), near)) walk.places.push_back(baseInOdom);
}

void ExploringDesk::sendOn(Walk& walk) {
    if (walk.tries > 0 && walk.tries % TriesABack == 0) pullBack(walk.robot);
    std::sort(walk.places.begin(), walk.places.end(),
              [&](const Pose& a, const Pose& b) { return distance(a, walk.here) > distance(b, walk.here); });
    PoseSample goal;
    goal.header.frame = shippedRobot(walk.robot).odomFrame;
    goal.poseInFrame = walk.places[walk.tries++ % walk.places.size()];
    (void)m_station->goTo(walk.robot, goal);
    walk.since = 0.0;
}

void ExploringDesk::pullBack(const std::string& robot) {
    m_station->setDriveFocus(robot);
    if (!m_station->setMode(robot, "teleoperation")) return;
    const auto end = std::chrono::steady_clock::now() + Pull;
    (void)waitUntil(
        [&] {
            const bool wait = m_station->robot(robot).drive.needsNeutral;
            m_station->setStick({wait ? 0.0 : -Gently, 0.0, 0.0}, true);
            return std::chrono::steady_clock::now() > end;
        },
        2 * Pull);
    m_station->setStick({});
    m_station->setDriveFocus({});
}

bool ExploringDesk::allExplore() const {
    const auto mission = m_station->mission();
    return std::all_of(m_walks.begin(), m_walks.end(), [&](const Walk& walk) {
        const RobotState* reported = stateOf(*mission, walk.robot);
        return reported && reported->mode->sample.mode == Explores;
    });
}

std::string ExploringDesk::doing() const {
    const auto mission = m_station->mission();
    std::string all;
    for (const Walk& walk : m_walks) {
        const RobotState* reported = stateOf(*mission, walk.robot);
        if (!reported) continue;
        const ModeSample& mode = reported->mode->sample;
        all += fmt::format(" {}: {:.0f} m, {} ({})", walk.robot, walk.length, mode.mode, mode.reason);
    }
    return all;
}

}  // namespace leitstand::test
