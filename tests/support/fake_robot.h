#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "robots/hardware/robot_hardware.h"
#include "tests/support/test_station.h"

namespace leitstand::test {

/// Hardware without a world: wheels that follow their voltage with a lag of 50 ms, time that a test passes.
class FakeRobot final : public RobotHardware {
public:
    [[nodiscard]] Time now() const override { return time; }
    [[nodiscard]] std::vector<HardwareSample> take() override { return std::exchange(samples, {}); }
    [[nodiscard]] TrackState tracks() const override { return {leftSpeed, rightSpeed}; }
    /// The wheels turn on by 10 ms.
    void turn() {
        leftSpeed += 0.2 * (fullSpeed * left - leftSpeed);
        rightSpeed += 0.2 * (fullSpeed * right - rightSpeed);
        if (brake) leftSpeed = rightSpeed = 0.0;
    }
    void setMotors(double l, double r) override { left = l, right = r; }
    void setBrake(bool on) override { brake = on; }
    void setPanTilt(const std::string& unit, double pan, double tilt) override {
        cameras[unit] = {pan, tilt};
    }
    void setStream(StreamRole role, const std::string& sensor, const StreamSettings& settings) override {
        streams[{role, sensor}] = settings;
    }
    [[nodiscard]] std::optional<TwistSample> remote() const override { return radio; }

    Time time{std::chrono::seconds(1'000)};
    double left = 0.0, right = 0.0;            ///< voltages
    double leftSpeed = 0.0, rightSpeed = 0.0;  ///< [m/s]
    double fullSpeed = 0.6;                    ///< [m/s]
    bool brake = false;
    std::vector<HardwareSample> samples;
    std::map<std::string, std::pair<double, double>> cameras;
    std::map<std::pair<StreamRole, std::string>, StreamSettings> streams;
    std::optional<TwistSample> radio;
};

/// Operates an agent on a FakeRobot as a station would, in virtual time.
template <class Agent>
class FakeStation : public TestStation {
public:
    FakeStation(FakeRobot& robot, Agent& agent, const std::string& name, std::uint8_t process = 1)
        : TestStation(agent, name, process), m_robot(robot), m_agent(agent) {}

    /// Passes time in steps of 10 ms with odometry at rest; what the agent says is kept.
    void pass(double seconds) {
        for (int i = 0; i < static_cast<int>(seconds * 100.0 + 0.5); ++i) {
            m_robot.time += std::chrono::milliseconds(10);
            m_robot.turn();
            OdometrySample odometry;
            odometry.header = {m_robot.time, "odom"};
            odometry.childFrame = "base_link";
            odometry.linear.x() = m_robot.tracks().left;
            m_robot.samples.push_back({StreamRole::Odometry, {}, odometry});
            for (HardwareSample& sample : m_agent.step()) received(std::move(sample));
        }
    }
    /// Drives for a while, renewing the grant and the command as a station does.
    void keepDriving(double forward, double seconds) {
        for (int i = 0; i < static_cast<int>(seconds * 20.0 + 0.5); ++i) {
            if (i % 20 == 0) hold();
            drive(forward);
            pass(0.05);
        }
    }

private:
    FakeRobot& m_robot;
    Agent& m_agent;
};

}  // namespace leitstand::test
