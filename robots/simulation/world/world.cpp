#include "robots/simulation/world/world.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <utility>

#include "core/base/mixed_bits.h"
#include "core/base/time.h"
#include "robots/simulation/world/robot.h"

namespace leitstand::simulation {
namespace {

constexpr std::chrono::nanoseconds LongestStep = std::chrono::milliseconds(5);
constexpr std::chrono::nanoseconds PartsEvery = std::chrono::milliseconds(20);
constexpr double Near = 1.0;  ///< distance of two robots that may touch [m]

}  // namespace

struct World::State {
    State(Arena arena, ArenaMesh mesh, std::uint64_t seedOfAll, Time startsAt)
        : scene(std::move(arena), std::move(mesh)), seed(seedOfAll), start(startsAt) {}

    struct Entry {
        std::unique_ptr<Robot> robot;
        bool ghost = false;
        bool changed = true;  ///< its place in the scene is out of date
    };

    Scene scene;
    std::uint64_t seed;
    Time start;
    std::chrono::nanoseconds elapsed{0};
    std::chrono::nanoseconds partsMoved{0};
    std::vector<Entry> robots;
    std::vector<std::string> names;  ///< of robots
    std::vector<Bump> bumps;

    [[nodiscard]] Time now() const { return start + elapsed; }
    Entry& at(int robot) { return robots.at(static_cast<std::size_t>(robot)); }

    int add(const BodySpec& spec, const Pose& pose, bool ghost) {
        const int body = scene.addBody(spec.shape);
        const std::uint64_t own = mixedBits(seed ^ mixedBits(static_cast<std::uint64_t>(body)));
        robots.push_back({std::make_unique<Robot>(spec, body, own, pose), ghost, true});
        names.push_back(spec.name);
        return body;
    }

    /// Moves bodies in the scene, and every 20 ms its moving parts.
    void updateScene() {
        bool changed = false;
        for (std::size_t i = 0; i < robots.size(); ++i) {
            if (!std::exchange(robots[i].changed, false)) continue;
            scene.place(static_cast<int>(i), robots[i].robot->state().baseInArena);
            changed = true;
        }
        const auto due = elapsed / PartsEvery * PartsEvery;
        if (due != partsMoved) {
            partsMoved = due;
            scene.setTime(toSeconds(due));
            changed = true;
        }
        if (changed) scene.commit();
    }

    [[nodiscard]] bool othersNear(std::size_t robot) const {
        const Eigen::Vector3d here = robots[robot].robot->state().baseInArena.translation();
        for (std::size_t i = 0; i < robots.size(); ++i) {
            if (i != robot && (robots[i].robot->state().baseInArena.translation() - here).norm() < Near)
                return true;
        }
        return false;
    }

    void step(std::chrono::nanoseconds step) {
        const double seconds = toSeconds(step);
        elapsed += step;
        for (std::size_t i = 0; i < robots.size(); ++i) {
            if (robots[i].ghost) continue;
            Robot& robot = *robots[i].robot;
            for (Bump& bump : robot.step({scene, names, now(), othersNear(i)}, seconds)) {
                bumps.push_back(std::move(bump));
            }
            robot.remember(now());
            robots[i].changed = robots[i].changed || robot.moved();
        }
        updateScene();
    }
};

World::World(Arena arena, ArenaMesh mesh, std::uint64_t seed, Time start)
    : m_state(std::make_unique<State>(std::move(arena), std::move(mesh), seed, start)) {}

World::~World() = default;

int World::addRobot(const BodySpec& spec) {
    const auto start = arena().starts.find(spec.name);
    if (start == arena().starts.end()) {
        throw std::invalid_argument("arena \"" + arena().name + "\" has no start for \"" + spec.name + "\"");
    }
    return addRobot(spec, start->second);
}

int World::addRobot(const BodySpec& spec, const Pose& baseInArena) {
    const int robot = m_state->add(spec, baseInArena, false);
    m_state->at(robot).robot->settle(m_state->scene);
    m_state->at(robot).robot->remember(now());
    m_state->updateScene();
    return robot;
}

int World::addGhost(const BodySpec& spec) {
    const int robot = m_state->add(spec, Pose::Identity(), true);
    m_state->at(robot).changed = false;  // nowhere until it is placed
    return robot;
}

void World::placeGhost(int robot, const Pose& baseInArena) {
    State::Entry& ghost = m_state->at(robot);
    if (!ghost.ghost) throw std::invalid_argument("robot " + std::to_string(robot) + " is no ghost");
    ghost.robot->moveTo(baseInArena, now());
    ghost.changed = true;
    m_state->updateScene();
}

void World::setMotors(int robot, double left, double right) {
    m_state->at(robot).robot->setMotors(left, right);
}

void World::setBrake(int robot, bool on) {
    m_state->at(robot).robot->setBrake(on);
}

void World::advance(std::chrono::nanoseconds step) {
    while (step.count() > 0) {
        const auto part = std::min(step, LongestStep);
        m_state->step(part);
        step -= part;
    }
}

Time World::now() const {
    return m_state->now();
}

double World::seconds() const {
    return toSeconds(m_state->elapsed);
}

const BodyState& World::state(int robot) const {
    return m_state->at(robot).robot->state();
}

Pose World::baseInArena(int robot, Time at) const {
    return m_state->at(robot).robot->history().at(at);
}

const std::vector<Bump>& World::bumps() const {
    return m_state->bumps;
}

const Scene& World::scene() const {
    return m_state->scene;
}

const Arena& World::arena() const {
    return m_state->scene.arena();
}

int World::robotCount() const {
    return static_cast<int>(m_state->robots.size());
}

const BodySpec& World::spec(int robot) const {
    return m_state->at(robot).robot->spec();
}

}  // namespace leitstand::simulation
