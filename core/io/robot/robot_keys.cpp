#include "core/io/robot/robot_keys.h"

#include <span>

namespace leitstand::detail {

std::vector<std::string> allRobotKeys() {
    std::vector<std::string> all;
    const auto add = [&all](const std::string& path, std::span<const std::string_view> keys) {
        for (const std::string_view key : keys) all.push_back(path + std::string(key));
    };
    add("", RobotKeys);
    add("frames.", FrameKeys);
    add("limits.", LimitKeys);
    add("sensors.NAME.", SensorKeys);
    add("sensors.NAME.pan_tilt.", PanTiltKeys);
    add("sensors.NAME.correction.", CorrectionKeys);
    add("streams[].", StreamKeys);
    add("streams[].qos.", QosKeys);
    add("streams[].thermal.", ThermalKeys);
    add("streams[].readings[].", ReadingKeys);
    add("services[].", ServiceKeys);
    add("joint_groups[].", JointGroupKeys);
    add("joint_groups[].joints[].", JointKeys);
    add("joint_groups[].joints[].link.", JointLinkKeys);
    add("joint_groups[].axes[].", JointAxisKeys);
    add("joint_groups[].presets[].", JointPresetKeys);
    all.emplace_back("sensors.NAME");
    all.emplace_back("bindings.ACTION");
    all.emplace_back("link_loss.MODE");
    return all;
}

}  // namespace leitstand::detail
