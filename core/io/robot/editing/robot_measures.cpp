#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "core/base/rotation/euler_angles.h"
#include "core/base/words.h"
#include "core/io/robot/editing/node_text.h"
#include "core/io/robot/editing/robot_edits.h"
#include "core/io/robot/robot_file.h"
#include "core/robot/footprint.h"
#include "core/robot/robot_description.h"

namespace leitstand {
namespace {

/// Returns @p value with at most @p decimals digits after the point: "0.5", "-90".
std::string numberText(double value, int decimals) {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string listText(const Eigen::Vector3d& values, int decimals) {
    return fmt::format("[{}, {}, {}]", numberText(values.x(), decimals), numberText(values.y(), decimals),
                       numberText(values.z(), decimals));
}

std::string outlineText(const std::vector<Eigen::Vector2d>& corners) {
    std::string text;
    for (const Eigen::Vector2d& corner : corners)
        text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", numberText(corner.x(), 3),
                            numberText(corner.y(), 3));
    return "[" + text + "]";
}

constexpr double InDegrees = 180.0 / std::numbers::pi;

/// Returns @p text with the place of the sensor @p name; empty when that is not supported.
std::string withSensor(std::string text, const std::string& name, const Pose& sensorInBase) {
    const std::string position = listText(sensorInBase.translation(), 3);
    const std::string rotation = listText(InDegrees * rollPitchYawOf(sensorInBase), 2);
    const std::string entry = fmt::format("{{position: {}, rotation: {}}}", position, rotation);
    const YAML::Node file = YAML::Load(text);
    if (!file["sensors"]) return detail::withEntry(text, file, "sensors", "{" + name + ": " + entry + "}");
    const YAML::Node sensor = file["sensors"][name];
    if (!sensor.IsDefined()) return detail::withEntry(text, file["sensors"], name, entry);
    text = detail::withEntry(std::move(text), sensor, "position", position);
    if (text.empty()) return {};
    return detail::withEntry(text, YAML::Load(text)["sensors"][name], "rotation", rotation);
}

bool isNear(const Pose& a, const Pose& b) {
    constexpr double Nearest = 2e-3;
    return (a.translation() - b.translation()).norm() < Nearest && (a.linear() - b.linear()).norm() < Nearest;
}

/// Returns @p before with what @p after has of @p measures; false: it has something else.
bool takeOver(RobotDescription& before, const RobotDescription& after, const RobotMeasures& measures) {
    constexpr double Nearest = 1e-3;
    if (after.footprint.size() != measures.footprint.size()) return false;
    if (std::abs(after.height - measures.height) > Nearest) return false;
    if (std::abs(signedArea(after.footprint) - std::abs(signedArea(measures.footprint))) > 0.1) return false;
    before.footprint = after.footprint;
    before.height = after.height;
    for (const auto& [name, pose] : measures.sensorsInBase) {
        const auto found = after.sensors.find(name);
        if (found == after.sensors.end() || !isNear(found->second.sensorInBase, pose)) return false;
        before.sensors.try_emplace(name, found->second).first->second.sensorInBase =
            found->second.sensorInBase;
    }
    return true;
}

}  // namespace

Result<std::string> withMeasures(const std::string& text, const std::string& name,
                                 const RobotMeasures& measures) {
    if (const std::string problem = footprintProblem(measures.footprint); !problem.empty())
        return Error{fmt::format("{}: footprint: {}", name, problem)};
    const Error byHand{
        leitstand::fill(translate("leitstand::Error",
                                  "{}: write this by hand: footprint: {}, height: {}, and places of sensors"),
                        name, outlineText(measures.footprint), numberText(measures.height, 3))};
    std::string result;
    try {
        result = detail::withEntry(text, YAML::Load(text), "footprint", outlineText(measures.footprint));
        if (!result.empty())
            result = detail::withEntry(result, YAML::Load(result), "height", numberText(measures.height, 3));
        for (const auto& [sensor, pose] : measures.sensorsInBase)
            if (!result.empty()) result = withSensor(result, sensor, pose);
    } catch (const YAML::Exception&) {
        return byHand;
    }
    // Nothing else may have changed, whatever the file looks like.
    const auto before = parseRobot(text, name);
    if (!before) return before.error();
    const auto after = parseRobot(result, name);
    if (result.empty() || !after) return byHand;
    RobotDescription wanted = *before;
    if (!takeOver(wanted, *after, measures) || writeRobot(wanted) != writeRobot(*after)) return byHand;
    return result;
}

}  // namespace leitstand
