#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/event/command_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/sample.h"
#include "core/event/station_samples.h"
#include "core/event/stream_role.h"
#include "core/robot/control/grants.h"
#include "robots/agent/robot_agent.h"

namespace leitstand::test {

/// A station that speaks to an agent without a network, and keeps what the agent says.
class TestStation {
public:
    /// @p process: tells stations apart.
    TestStation(RobotAgent& agent, std::string robot, std::uint8_t process = 1)
        : m_agent(agent), m_robot(std::move(robot)), m_name("station " + std::to_string(process)) {
        m_me.bytes[0] = process;
    }
    /// The heartbeat of the drive grant.
    void hold() {
        GrantSample grant;
        grant.station = m_name;
        grant.robot = m_robot;
        m_agent.receive(grant, m_me);
    }
    void drive(double forward, double turn = 0.0) {
        TwistSample twist;
        twist.linear.x() = forward;
        twist.angular.z() = turn;
        publish(StreamRole::DriveCommand, twist);
    }
    void stop(std::uint64_t number, bool stop = true, std::uint64_t releases = 0) {
        publish(StreamRole::StopCommand, StopCommandSample{{}, m_name, number, stop, releases});
    }
    void mode(const std::string& wanted) {
        publish(StreamRole::ModeCommand, ModeCommandSample{{}, m_name, wanted});
    }
    void publish(StreamRole role, const Sample& sample) { m_agent.receive(role, sample, m_me); }

    void received(HardwareSample sample) { reported.push_back(std::move(sample)); }
    template <class Kind>
    [[nodiscard]] std::vector<Kind> all() const {
        std::vector<Kind> found;
        for (const HardwareSample& sample : reported) {
            if (const auto* one = sample.sample.as<Kind>()) found.push_back(*one);
        }
        return found;
    }
    std::vector<HardwareSample> reported;  ///< by the agent

private:
    RobotAgent& m_agent;
    std::string m_robot, m_name;
    Sender m_me;
};

}  // namespace leitstand::test
