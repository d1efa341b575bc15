#include "core/io/settings/alarm_file.h"

#include <algorithm>
#include <array>
#include <fstream>

#include <yaml-cpp/yaml.h>

#include "core/base/words.h"
#include "core/io/yaml/yaml_document.h"
#include "core/io/yaml/yaml_fields.h"

namespace leitstand {
namespace {

using detail::YamlErrors;
using detail::YamlFields;

/// A number of the file.
struct Key {
    std::string_view name;
    double AlarmLimits::*value;
    double least, most;
    const char* unit;
    double inUnit = 1.0;  ///< unit of the file in units of AlarmLimits
};

constexpr double Percent = 0.01;
const std::array Keys = {
    Key{"co2", &AlarmLimits::gas, 400.0, 100'000.0, " ppm"},
    Key{"attitude", &AlarmLimits::attitude, 10.0, 100.0, " %", Percent},
    Key{"attitude_act", &AlarmLimits::attitudeAct, 10.0, 100.0, " %", Percent},
    Key{"battery_minutes", &AlarmLimits::batteryMinutes, 0.0, 600.0, " min"},
    Key{"battery_minutes_act", &AlarmLimits::batteryMinutesAct, 0.0, 600.0, " min"},
    Key{"battery", &AlarmLimits::batteryShare, 0.0, 100.0, " %", Percent},
    Key{"battery_act", &AlarmLimits::batteryShareAct, 0.0, 100.0, " %", Percent},
    Key{"stop_unanswered", &AlarmLimits::unanswered, 0.5, 60.0, " s"},
    Key{"wheels_spin", &AlarmLimits::spinning, 0.1, 100.0, " m"},
    Key{"frozen_picture", &AlarmLimits::frozen, 0.5, 60.0, " s"},
    Key{"clock", &AlarmLimits::clock, 0.1, 1e6, " s"},
};

std::array<std::string_view, Keys.size()> names() {
    std::array<std::string_view, Keys.size()> all;
    std::transform(Keys.begin(), Keys.end(), all.begin(), [](const Key& key) { return key.name; });
    return all;
}

}  // namespace

Result<AlarmLimits> parseAlarmLimits(std::string_view text, const std::string& name) {
    AlarmLimits limits;
    const auto root = detail::loadYaml(text, name);
    if (!root) return root.error();
    if (root->IsNull()) return limits;
    YamlErrors errors(name);
    try {
        const auto known = names();
        const YamlFields fields({*root, {}, 1}, known, errors);
        for (const Key& key : Keys) {
            double value = limits.*key.value / key.inUnit;
            if (fields.number(key.name, value, key.least, key.most, key.unit))
                limits.*key.value = value * key.inUnit;
        }
        if (errors.empty()) return limits;
    } catch (const YAML::Exception& problem) {
        errors.add(std::max(0, problem.mark.line) + 1, {},
                   leitstand::fill(translate("leitstand::Error", "expected YAML, found a mistake: {}"),
                                   problem.msg));
    }
    return errors.error();
}

Result<AlarmLimits> readAlarmLimits(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) return AlarmLimits();
    std::ifstream in(file, std::ios::binary);
    if (!in || std::filesystem::is_directory(file, ignored))
        return Error{leitstand::fill(
            translate("leitstand::Error", "{}: expected limits of alarms, found no file that can be read"),
            file.string())};
    std::string text(detail::LargestYaml + 1, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
    return parseAlarmLimits(text, file.string());
}

}  // namespace leitstand
