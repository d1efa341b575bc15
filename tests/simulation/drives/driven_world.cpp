#include "tests/simulation/drives/driven_world.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include "core/event/command_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "core/io/robot/robot_file.h"
#include "core/robot/robot_format.h"
#include "robots/control/fuzzy/fuzzy_file.h"
#include "robots/crawler/crawler_agent.h"
#include "robots/kurt3d/kurt3d_agent.h"
#include "robots/simulation/arena/mesh.h"
#include "tests/support/places.h"

namespace leitstand::simulation::test {
namespace {

const std::string Resources = leitstand::test::sourceFolder() + "/resources/";

std::unique_ptr<RobotAgent> agentFor(const std::string& kind, RobotHardware& hardware,
                                     const RobotDescription& robot) {
    const FuzzySystem rules = readFuzzySystem(Resources + "control/fuzzy_drive.yaml").value();
    if (kind == "crawler") return CrawlerAgent::create(hardware, robot, rules).value();
    return Kurt3dAgent::create(hardware, robot, rules).value();
}

}  // namespace

RobotDescription shippedRobot(const std::string& kind) {
    return readRobot(Resources + "robots/" + kind + ".yaml").value();
}

DrivenWorld::DrivenWorld(const Arena& arena, const DriveSetup& setup)
    : DrivenWorld(arena, meshOf(arena), setup) {}

DrivenWorld::DrivenWorld(Arena arena, ArenaMesh mesh, const DriveSetup& setup)
    : world(std::make_unique<World>(std::move(arena), std::move(mesh), setup.seed)) {
    const RobotDescription description = shippedRobot(setup.kind);
    const BodySpec body = setup.kind == "crawler" ? crawlerBody() : kurt3dBody();
    robot = setup.start ? world->addRobot(body, *setup.start) : world->addRobot(body);
    HardwareSettings fitting;
    fitting.seed = setup.seed;
    fitting.scanner = setup.scanner;
    hardware = std::make_unique<BreakableHardware>(
        setup.kind == "crawler" ? makeCrawlerHardware(*world, robot, description, fitting)
                                : makeKurt3dHardware(*world, robot, description, fitting));
    agent = agentFor(setup.kind, *hardware, description);
    station = std::make_unique<leitstand::test::TestStation>(*agent, description.name);
    station->hold();
    for (const StreamDescription& stream : description.streams) {
        const bool picture = stream.role == StreamRole::Picture;
        if (!picture && (setup.infrared || stream.role != StreamRole::Thermal)) continue;
        StreamCommandSample off;
        off.topic = stream.topic;
        off.enabled = false;
        station->publish(StreamRole::StreamCommand, off);
    }
}

void DrivenWorld::step() {
    world->advance(std::chrono::milliseconds(5));
    if (radio && m_steps % 200 == 0) station->hold();
    if (radio && sticks && m_steps % 10 == 0) station->drive(sticks->forward, sticks->turn);
    ++m_steps;
    for (HardwareSample& sample : agent->step()) {
        if (onSample) onSample(sample);
        if (const auto* odometry = sample.sample.as<OdometrySample>()) {
            m_baseInOdom = odometry->baseInOdom;
        } else if (const auto* found = sample.sample.as<SightingSample>()) {
            sightings = found->sightings;
        } else if (const auto* mode = sample.sample.as<ModeSample>()) {
            for (const robot_format::Part& part : robot_format::partsOf(mode->reason))
                EXPECT_NE(part.words, nullptr) << "stations cannot translate it: " << part.value;
            modes.push_back(*mode);
        } else if (sample.sample.is<StopStateSample>() || sample.sample.is<BumpSample>()) {
            station->received(std::move(sample));
        }
    }
}

void DrivenWorld::pass(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 200.0 + 0.5); ++i) step();
}

void DrivenWorld::drive(double forward, double turn, double seconds) {
    sticks = DriveVelocity{forward, 0.0, turn};
    pass(seconds);
}

void DrivenWorld::ask(const std::string& mode) {
    station->mode(mode);
    pass(0.1);
}

double DrivenWorld::yaw() const {
    const Eigen::Vector3d ahead = state().baseInArena.linear().col(0);
    return std::atan2(ahead.y(), ahead.x());
}

std::string DrivenWorld::reason() const {
    return modes.empty() ? std::string() : modes.back().reason;
}

Eigen::Vector3d DrivenWorld::inArena(const Eigen::Vector3d& inOdom) const {
    return state().baseInArena * (m_baseInOdom.inverse() * inOdom);
}

double DrivenWorld::fromFrontTo(const std::string& name) const {
    // Rays from the front edge ahead and to the sides, at some heights, as in a fan.
    const auto& elements = world->arena().elements;
    const auto front = world->spec(robot).outline;
    double ahead = 0.0, left = 0.0;
    for (const Eigen::Vector2d& corner : front) {
        ahead = std::max(ahead, corner.x());
        left = std::max(left, corner.y());
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (double side = -left; side <= left + 1e-9; side += left / 8.0) {
        for (int turn = -80; turn <= 80; turn += 2) {
            for (double height = 0.03; height < 0.65; height += 0.04) {
                const double yaw = degrees(turn);
                Ray ray;
                ray.origin = (state().baseInArena * Eigen::Vector3d(ahead, side, height)).cast<float>();
                ray.direction =
                    (state().baseInArena.linear() * Eigen::Vector3d(std::cos(yaw), std::sin(yaw), 0.0))
                        .cast<float>();
                const Hit hit = world->scene().cast(ray, RayKind::Camera, robot);
                if (!hit.there() || hit.surface->element < 0) continue;
                if (elements[static_cast<std::size_t>(hit.surface->element)].name != name) continue;
                nearest = std::min(nearest, static_cast<double>(hit.distance));
            }
        }
    }
    return nearest;
}

}  // namespace leitstand::simulation::test
