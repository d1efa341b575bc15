#include "tests/simulation/world/operated_robot.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "core/base/rotation/heading.h"
#include "core/event/command_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/station_samples.h"
#include "core/event/stream_role.h"
#include "core/io/robot/robot_file.h"
#include "robots/control/fuzzy/fuzzy_file.h"
#include "robots/crawler/crawler_agent.h"
#include "robots/kurt3d/kurt3d_agent.h"
#include "robots/simulation/world/motion/suspension.h"
#include "tests/support/places.h"

namespace leitstand::simulation {
namespace {

using namespace std::chrono_literals;

const std::string Resources = leitstand::test::sourceFolder() + "/resources/";

BodySpec bodyOf(const std::string& kind) {
    return kind == "kurt3d" ? kurt3dBody() : crawlerBody();
}

std::unique_ptr<RobotAgent> agentOf(const std::string& kind, RobotHardware& hardware,
                                    const RobotDescription& robot) {
    const auto rules = readFuzzySystem(Resources + "control/fuzzy_drive.yaml");
    if (kind == "crawler") return CrawlerAgent::create(hardware, robot, *rules).value();
    return Kurt3dAgent::create(hardware, robot, *rules).value();
}

}  // namespace

OperatedRobot::OperatedRobot(World& world, const std::string& kind, const HardwareSettings& fitting)
    : OperatedRobot(world, kind, world.addRobot(bodyOf(kind)), fitting) {}

OperatedRobot::OperatedRobot(World& world, const std::string& kind, const Pose& baseInArena,
                             const HardwareSettings& fitting)
    : OperatedRobot(world, kind, world.addRobot(bodyOf(kind), baseInArena), fitting) {}

OperatedRobot::OperatedRobot(World& world, const std::string& kind, int number,
                             const HardwareSettings& fitting)
    : m_world(world),
      m_number(number),
      m_description(readRobot(Resources + "robots/" + kind + ".yaml").value()),
      m_hardware(kind == "kurt3d" ? makeKurt3dHardware(world, number, m_description, fitting)
                                  : makeCrawlerHardware(world, number, m_description, fitting)),
      m_agent(agentOf(kind, *m_hardware, m_description)) {
    m_station.bytes[0] = 1;
}

void OperatedRobot::request(double forward, double turn) {
    const DriveVelocity request{forward, 0.0, turn};
    m_changed = m_changed || request.forward != m_requested.forward;
    m_requested = request;
}

void OperatedRobot::wishHeading(double speed, double heading) {
    const double off = std::remainder(heading - headingOf(state().baseInArena), 2.0 * std::numbers::pi);
    request(speed, std::clamp(2.0 * off, -0.8, 0.8));
}

void OperatedRobot::stop() {
    m_agent->receive(StreamRole::StopCommand, StopCommandSample{{}, "station 1", ++m_stops, true, 0},
                     m_station);
}

void OperatedRobot::remote(const std::optional<TwistSample>& twist) {
    dynamic_cast<SimulatedRobot&>(*m_hardware).setRemote(twist);
}

void OperatedRobot::turn() {
    const Time now = m_world.now();
    if (now - m_turned < m_period) return;
    m_turned = now;
    if (now - m_held >= 1s) {
        m_held = now;
        GrantSample grant;
        grant.station = "station 1";
        grant.robot = m_description.name;
        m_agent->receive(grant, m_station);
    }
    if (m_changed || now - m_commanded >= 50ms) {
        m_commanded = now;
        m_changed = false;
        TwistSample twist;  // neutral before anything moves
        if (m_neutral) twist.linear.x() = m_requested.forward;
        if (m_neutral) twist.angular.z() = m_requested.turn;
        m_neutral = true;
        m_agent->receive(StreamRole::DriveCommand, twist, m_station);
    }
    for (HardwareSample& sample : m_agent->step()) m_said.push_back(std::move(sample));
}

void pass(World& world, std::initializer_list<OperatedRobot*> robots, double seconds,
          const OperatedRobot::EachStep& each) {
    for (int i = 0; i < static_cast<int>(seconds * 200.0 + 0.5); ++i) {
        world.advance(5ms);
        for (OperatedRobot* robot : robots) {
            if (each) each(*robot);
            robot->turn();
        }
    }
}

}  // namespace leitstand::simulation
