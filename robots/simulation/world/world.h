#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "robots/simulation/scene/scene.h"
#include "robots/simulation/world/body.h"

namespace leitstand::simulation {

/// A collision of a robot.
struct Bump {
    Time at{};
    int robot = 0;
    bool victim = false;                              ///< whether it hit a victim
    std::string element;                              ///< name of the element or robot that it hit
    Eigen::Vector2d where = Eigen::Vector2d::Zero();  ///< where it was hit, in base_link [m]
};

/// True motion of a robot.
struct BodyState {
    Pose baseInArena = Pose::Identity();
    Eigen::Vector3d linear = Eigen::Vector3d::Zero();   ///< in base_link [m/s]
    Eigen::Vector3d angular = Eigen::Vector3d::Zero();  ///< in base_link [rad/s]
    double left = 0.0, right = 0.0;                ///< speeds of the wheels, as encoders measure them [m/s]
    double leftCurrent = 0.0, rightCurrent = 0.0;  ///< [A]
    /// How far the wheels have turned since the beginning [m].
    double travelledLeft = 0.0, travelledRight = 0.0;
    bool tipped = false;   ///< whether it lies on its side or back, and stays there
    bool blocked = false;  ///< whether something stops it now
};

/// An arena with robots in it, with its own clock. It is deterministic for an arena and a seed
/// (docs/simulated-robots.md, "How robots move"). Where an arena has no floor, there is a floor at z = 0.
class World {
public:
    World(const Arena& arena, std::uint64_t seed, Time start = Time(std::chrono::seconds(1'000'000)));
    /// Uses triangles that were made elsewhere: @p mesh need not be meshOf(@p arena).
    World(Arena arena, ArenaMesh mesh, std::uint64_t seed,
          Time start = Time(std::chrono::seconds(1'000'000)));
    ~World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    /// Puts a robot on the ground at its start in the arena. Returns its number. Throws std::invalid_argument
    /// when the arena has no start for the robot's name.
    int addRobot(const BodySpec& spec);
    int addRobot(const BodySpec& spec, const Pose& baseInArena);
    /// Adds a robot that another process moves. It collides like any other. Returns its number.
    int addGhost(const BodySpec& spec);
    void placeGhost(int robot, const Pose& baseInArena);

    /// Voltages, -1 to 1; values that are not finite mean 0.
    void setMotors(int robot, double left, double right);
    void setBrake(int robot, bool on);

    /// Advances the world by @p step, in smaller steps of at most 5 ms. Moving parts move every 20 ms.
    void advance(std::chrono::nanoseconds step);
    [[nodiscard]] Time now() const;
    [[nodiscard]] double seconds() const;  ///< time since the beginning

    [[nodiscard]] const BodyState& state(int robot) const;
    /// Returns the interpolated pose of a robot at a time within the last 5 s.
    [[nodiscard]] Pose baseInArena(int robot, Time at) const;
    [[nodiscard]] const std::vector<Bump>& bumps() const;  ///< all since the beginning, each counted once
    /// Scene at the present time; bodies have the numbers of robots.
    [[nodiscard]] const Scene& scene() const;
    [[nodiscard]] const Arena& arena() const;
    [[nodiscard]] int robotCount() const;
    [[nodiscard]] const BodySpec& spec(int robot) const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand::simulation
