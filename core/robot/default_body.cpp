#include "core/robot/default_body.h"

namespace leitstand {
namespace {

void fill(double& value, double usual) {
    if (!(value > 0.0)) value = usual;
}

}  // namespace

void fillBody(RobotDescription& robot) {
    if (robot.baseFrame.empty()) robot.baseFrame = "base_link";
    if (robot.odomFrame.empty()) robot.odomFrame = "odom";
    if (robot.footprint.size() < 3)
        robot.footprint = {{0.25, 0.2}, {-0.25, 0.2}, {-0.25, -0.2}, {0.25, -0.2}};
    fill(robot.height, 0.5);
    fill(robot.maxRoll, degrees(25));
    fill(robot.maxPitch, degrees(25));
    fill(robot.maxSpeed, 0.3);
    fill(robot.maxTurnRate, degrees(30));
}

}  // namespace leitstand
