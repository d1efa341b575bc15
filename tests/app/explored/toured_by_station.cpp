#include "tests/app/explored/toured_by_station.h"

#include <algorithm>
#include <utility>

#include "core/event/motion_samples.h"
#include "core/mission/state/mission_state.h"
#include "core/mission/state/robot_state.h"
#include "tests/app/robots/robot_process.h"

namespace leitstand::test {

TouredByStation::TouredByStation(Station& station, const ArenaTruth& truth, std::string robot)
    : m_station(station), m_truth(truth), m_robot(std::move(robot)) {}

double TouredByStation::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_began).count();
}

Pose TouredByStation::baseInArena() const {
    return m_truth.newest(m_robot).value_or(Pose::Identity());
}

ModeSample TouredByStation::mode() const {
    const auto mission = m_station.mission();
    const auto reported = mission->robots.find(m_robot);
    return reported != mission->robots.end() && reported->second->mode ? reported->second->mode->sample
                                                                       : ModeSample();
}

void TouredByStation::ask(const std::string& mode) {
    (void)m_station.setMode(m_robot, mode);
}

void TouredByStation::send(const Eigen::Vector3d& inBase) {
    const auto mission = m_station.mission();
    const auto& odometry = mission->robots.at(m_robot)->odometry;
    if (!odometry) return;
    PoseSample goal;
    goal.header.frame = shippedRobot(m_robot).odomFrame;
    goal.poseInFrame.translation() = odometry->sample.baseInOdom * inBase;
    (void)m_station.goTo(m_robot, goal);
}

bool TouredByStation::take() {
    const auto& robots = m_station.robots();
    const bool others = std::any_of(robots.begin(), robots.end(), [this](const RobotDescription& other) {
        return other.name != m_robot && m_station.robot(other.name).drive.focus;
    });
    if (others) return false;
    m_station.setDriveFocus(m_robot);
    m_station.setStick({}, true);
    return m_station.robot(m_robot).drive.focus && !m_station.robot(m_robot).drive.needsNeutral;
}

void TouredByStation::drive(double forward, double turn) {
    m_station.setStick({forward, 0.0, turn}, true);
}

void TouredByStation::release() {
    m_station.setStick({});
    m_station.setDriveFocus({});
}

}  // namespace leitstand::test
