#pragma once

#include <string>
#include <vector>

#include "tests/simulation/mapping/toured_robot.h"
#include "tests/simulation/world/operated_robot.h"

namespace leitstand::simulation::test {

/// A robot in a world in virtual time, on its tour.
class TouredInWorld : public TouredRobot {
public:
    explicit TouredInWorld(OperatedRobot& robot);
    void receive(const std::vector<HardwareSample>& reported);  ///< what the robot said since

    [[nodiscard]] double seconds() const override { return m_robot.world().seconds(); }
    [[nodiscard]] Pose baseInArena() const override { return m_robot.state().baseInArena; }
    [[nodiscard]] ModeSample mode() const override { return m_mode; }
    void ask(const std::string& mode) override;
    void send(const Eigen::Vector3d& inBase) override;
    bool take() override;
    void drive(double forward, double turn) override { m_robot.request(forward, turn); }
    void release() override { m_robot.request(0.0); }

private:
    OperatedRobot& m_robot;
    Sender m_station;
    Pose m_baseInOdom = Pose::Identity();
    ModeSample m_mode;
};

}  // namespace leitstand::simulation::test
