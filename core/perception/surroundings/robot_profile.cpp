#include "core/perception/surroundings/robot_profile.h"

namespace leitstand {

ProfileSettings profileOf(const RobotDescription& robot, ProfileSettings usual) {
    if (robot.height > 0.0) usual.height = robot.height + HeadClearance;
    if (robot.maxClimb > 0.0) usual.climb = robot.maxClimb;
    if (robot.maxStep > 0.0) usual.step = robot.maxStep;
    return usual;
}

}  // namespace leitstand
