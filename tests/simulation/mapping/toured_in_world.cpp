#include "tests/simulation/mapping/toured_in_world.h"

#include "core/event/command_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"

namespace leitstand::simulation::test {

TouredInWorld::TouredInWorld(OperatedRobot& robot) : m_robot(robot) {
    m_station.bytes[0] = 1;
}

void TouredInWorld::receive(const std::vector<HardwareSample>& reported) {
    for (const HardwareSample& sample : reported) {
        if (const auto* mode = sample.sample.as<ModeSample>()) m_mode = *mode;
        if (const auto* odometry = sample.sample.as<OdometrySample>()) m_baseInOdom = odometry->baseInOdom;
    }
}

void TouredInWorld::ask(const std::string& mode) {
    m_robot.agent().receive(StreamRole::ModeCommand, ModeCommandSample{{}, "station 1", mode}, m_station);
}

void TouredInWorld::send(const Eigen::Vector3d& inBase) {
    PoseSample goal;
    goal.header.frame = m_robot.description().odomFrame;
    goal.poseInFrame.translation() = m_baseInOdom * inBase;
    m_robot.agent().receive(StreamRole::GoalPose, goal, m_station);
}

bool TouredInWorld::take() {
    m_robot.request(0.0);
    return true;
}

}  // namespace leitstand::simulation::test
