#include <algorithm>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "core/base/words.h"
#include "core/io/robot/robot_file.h"

namespace leitstand {
namespace {

/// Returns the offset of @p mark in @p text.
std::size_t placeOf(const std::string& text, const YAML::Mark& mark) {
    std::size_t at = 0;
    for (int i = 0; i < mark.line && at < text.size(); ++i) {
        const std::size_t end = text.find('\n', at);
        at = end == std::string::npos ? text.size() : end + 1;
    }
    return std::min(at + static_cast<std::size_t>(std::max(0, mark.column)), text.size());
}

/// Returns @p text with @p line as an entry of the sensor @p of, in place of an earlier correction. Empty
/// when the file is written in a way that is not supported here.
std::string withLine(std::string text, const YAML::Node& of, const std::string& line) {
    if (!of.IsDefined() || !of.IsMap()) return {};
    for (const auto& entry : of) {
        if (entry.first.as<std::string>() != "correction") continue;
        if (entry.second.Style() != YAML::EmitterStyle::Flow) return {};
        const std::size_t begin = placeOf(text, entry.first.Mark()), end = text.find('}', begin);
        if (end == std::string::npos) return {};
        return text.replace(begin, end + 1 - begin, line);
    }
    if (of.Style() == YAML::EmitterStyle::Flow) {
        const std::size_t brace = placeOf(text, of.Mark());
        if (brace >= text.size() || text[brace] != '{') return {};
        return text.insert(brace + 1, of.size() == 0 ? line : line + ", ");
    }
    const YAML::Mark first = of.begin()->first.Mark();
    const std::string indent(static_cast<std::size_t>(std::max(0, first.column)), ' ');
    return text.insert(placeOf(text, first), line + "\n" + indent);
}

}  // namespace

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
        result = withLine(text, YAML::Load(text)["sensors"][sensor], correctionLine(correction));
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
