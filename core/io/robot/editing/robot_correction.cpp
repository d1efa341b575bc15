#include <algorithm>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "core/base/words.h"
#include "core/io/robot/editing/node_text.h"
#include "core/io/robot/editing/robot_edits.h"
#include "core/io/robot/robot_file.h"

namespace leitstand {

std::string correctionLine(const ScannerCorrection& correction) {
    std::string line = fmt::format("correction: {{range: {:.4f}, roll: {:.3f}, pitch: {:.3f}",
                                   correction.range, inDegrees(correction.roll), inDegrees(correction.pitch));
    const auto add = [&line](const char* key, const std::string& value) {
        if (std::any_of(value.begin(), value.end(), [](char c) { return c >= '1' && c <= '9'; }))
            line += fmt::format(", {}: {}", key, value);
    };
    add("x", fmt::format("{:.4f}", correction.x));
    add("y", fmt::format("{:.4f}", correction.y));
    add("yaw", fmt::format("{:.3f}", inDegrees(correction.yaw)));
    add("clock", fmt::format("{:.4f}", correction.clock));
    return line + "}";
}

Result<std::string> withCorrection(const std::string& text, const std::string& name,
                                   const std::string& sensor, const ScannerCorrection& correction) {
    const Error byHand{
        leitstand::fill(translate("leitstand::Error", "{}: write this below sensors, {}, by hand: {}"), name,
                        sensor, correctionLine(correction))};
    std::string result;
    try {
        // The line is "correction: {...}".
        const std::string line = correctionLine(correction);
        const std::size_t colon = line.find(": ");
        result = detail::withEntry(text, YAML::Load(text)["sensors"][sensor], line.substr(0, colon),
                                   line.substr(colon + 2));
    } catch (const YAML::Exception&) {
        return byHand;
    }
    // Nothing else may have changed, whatever the file looks like.
    const auto before = parseRobot(text, name), after = parseRobot(result, name);
    if (result.empty() || !before || !after) return byHand;
    RobotDescription wanted = *before;
    const auto read = after->sensors.find(sensor);
    if (read == after->sensors.end() || correctionLine(read->second.correction) != correctionLine(correction))
        return byHand;
    wanted.sensors.at(sensor).correction = read->second.correction;
    if (writeRobot(wanted) != writeRobot(*after)) return byHand;
    return result;
}

}  // namespace leitstand
