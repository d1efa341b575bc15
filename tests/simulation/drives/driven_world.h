#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/robot/control/drive_setpoint.h"
#include "robots/agent/robot_agent.h"
#include "robots/simulation/simulated_hardware.h"
#include "robots/simulation/world/world.h"
#include "tests/simulation/drives/breakable_hardware.h"
#include "tests/support/test_station.h"

namespace leitstand::simulation::test {

/// What a robot is driven with.
struct DriveSetup {
    std::string kind = "kurt3d";
    std::uint64_t seed = 1;
    std::optional<Pose> start;  ///< of base_link in the arena; empty: the arena's start
    bool infrared = true;       ///< the camera that finds victims; others are switched off by stream commands
    ScannerMount scanner = ScannerMount::ScanDrive;
};

/// One robot in a world with its agent and an operator at a station, in one process on the world's clock.
class DrivenWorld {
public:
    DrivenWorld(const Arena& arena, const DriveSetup& setup);
    DrivenWorld(Arena arena, ArenaMesh mesh, const DriveSetup& setup);

    /// Passes time in steps of 5 ms as a robot's process does; the operator's station says its grant once a
    /// second and the sticks 20 times a second, while there is a radio.
    void pass(double seconds);
    /// ... with the sticks at that.
    void drive(double forward, double turn, double seconds);
    /// Asks for a mode. The robot must be in it within 0.1 s.
    void ask(const std::string& mode);
    /// The sticks are let go of, then the mode is asked for.
    void let() { sticks = DriveVelocity{}; }

    [[nodiscard]] const BodyState& state() const { return world->state(robot); }
    [[nodiscard]] Eigen::Vector2d place() const { return state().baseInArena.translation().head<2>(); }
    [[nodiscard]] double speed() const { return state().linear.head<2>().norm(); }
    [[nodiscard]] double yaw() const;
    [[nodiscard]] DriveMode mode() const { return agent->mode(); }
    [[nodiscard]] std::string reason() const;  ///< that it told last
    [[nodiscard]] int bumps() const { return static_cast<int>(world->bumps().size()); }
    /// A place that the robot told in odom, where it truly is, by where the robot is now: free of the drift
    /// of its odometry.
    [[nodiscard]] Eigen::Vector3d inArena(const Eigen::Vector3d& inOdom) const;
    [[nodiscard]] const Pose& baseInOdom() const { return m_baseInOdom; }
    /// The distance from the front of the robot to the nearest surface of element @p name, between the
    /// ground and the robot's height [m].
    [[nodiscard]] double fromFrontTo(const std::string& name) const;

    std::unique_ptr<World> world;
    int robot = 0;
    std::unique_ptr<BreakableHardware> hardware;
    std::unique_ptr<RobotAgent> agent;
    std::unique_ptr<leitstand::test::TestStation> station;
    bool radio = true;                                    ///< false: nothing is heard of the station
    std::optional<DriveVelocity> sticks;                  ///< empty: nobody drives by hand
    std::vector<Sighting> sightings;                      ///< newest that it told
    std::vector<ModeSample> modes;                        ///< all that it told
    std::function<void(const HardwareSample&)> onSample;  ///< told of everything that it says; may be empty

private:
    void step();
    Pose m_baseInOdom = Pose::Identity();
    int m_steps = 0;
};

/// A robot's description as shipped.
[[nodiscard]] RobotDescription shippedRobot(const std::string& kind);

}  // namespace leitstand::simulation::test
