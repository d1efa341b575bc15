#include "core/robot/frame_names.h"

namespace leitstand {
namespace {

std::string withoutSlash(const std::string& frame) {
    return frame.starts_with('/') ? frame.substr(1) : frame;
}

}  // namespace

std::string frameName(const RobotDescription& robot, const std::string& frame) {
    std::string name = withoutSlash(frame);
    const std::string prefix = robot.name + "/";
    if (robot.tfPrefix != TfPrefix::Topic || name.empty() || name.starts_with(prefix)) return name;
    return prefix + name;
}

bool isOwnTransform(const RobotDescription& robot, const std::string& parent, const std::string& child) {
    if (robot.tfPrefix != TfPrefix::Frame) return true;
    const std::string prefix = robot.name + "/";
    return withoutSlash(child).starts_with(prefix) || withoutSlash(parent).starts_with(prefix);
}

}  // namespace leitstand
