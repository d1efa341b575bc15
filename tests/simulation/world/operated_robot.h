#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/event/motion_samples.h"
#include "core/robot/control/drive_setpoint.h"
#include "robots/agent/robot_agent.h"
#include "robots/simulation/simulated_hardware.h"
#include "robots/simulation/simulated_robot.h"
#include "robots/simulation/world/world.h"

namespace leitstand::simulation {

/// A robot with its agent and its sensors in a world, operated as by a station, in virtual time.
class OperatedRobot {
public:
    /// What happens in each step of the world, before its agent's: here a test operates.
    using EachStep = std::function<void(OperatedRobot& robot)>;

    /// @p kind: "kurt3d" or "crawler", put to where the arena has it start, or to @p baseInArena.
    OperatedRobot(World& world, const std::string& kind,
                  const HardwareSettings& fitting = {.cameras = false});
    OperatedRobot(World& world, const std::string& kind, const Pose& baseInArena,
                  const HardwareSettings& fitting = {.cameras = false});

    /// The sticks of its operator from now on; the grant and the command are renewed as a station does.
    void request(double forward, double turn = 0.0);
    /// Puts the sticks so that it drives at @p speed and turns to @p heading (arena's frame), as somebody
    /// does who looks where it points.
    void wishHeading(double speed, double heading);
    void stop();
    /// The radio remote; empty: it is put down.
    void remote(const std::optional<TwistSample>& twist);
    /// Says what the station has to say and turns its agent once: after each step of the world.
    void turn();

    [[nodiscard]] const BodyState& state() const { return m_world.state(m_number); }
    [[nodiscard]] int number() const { return m_number; }
    [[nodiscard]] const RobotDescription& description() const { return m_description; }
    [[nodiscard]] RobotAgent& agent() { return *m_agent; }
    [[nodiscard]] World& world() { return m_world; }
    /// All that it said of a kind.
    template <class Kind>
    [[nodiscard]] std::vector<Kind> all() const {
        std::vector<Kind> found;
        for (const HardwareSample& sample : m_said) {
            if (const auto* one = sample.sample.as<Kind>()) found.push_back(*one);
        }
        return found;
    }
    [[nodiscard]] const std::vector<HardwareSample>& reported() const { return m_said; }
    void forget() { m_said.clear(); }
    void turnEvery(std::chrono::nanoseconds period) { m_period = period; }  ///< of its agent; 5 ms

private:
    OperatedRobot(World& world, const std::string& kind, int number, const HardwareSettings& fitting);

    World& m_world;
    int m_number;
    RobotDescription m_description;
    std::unique_ptr<RobotHardware> m_hardware;
    std::unique_ptr<RobotAgent> m_agent;
    Sender m_station;
    DriveVelocity m_requested;
    std::chrono::nanoseconds m_period = std::chrono::milliseconds(5);
    Time m_turned{}, m_held{}, m_commanded{};
    bool m_neutral = false,
         m_changed = false;  ///< sticks: a zero was said; they moved since the last command
    std::uint64_t m_stops = 0;
    std::vector<HardwareSample> m_said;
};

/// Passes @p seconds in steps of 5 ms, in which all @p robots of @p world turn; @p each before every turn.
void pass(World& world, std::initializer_list<OperatedRobot*> robots, double seconds,
          const OperatedRobot::EachStep& each = {});

}  // namespace leitstand::simulation
