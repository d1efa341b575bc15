#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/station/alarms/alarm_rules.h"

namespace leitstand {

/// Reads the limits beyond which the operator is alarmed (YAML; docs/alarms.md, "Limits"). A limit that is
/// not named keeps its default. Errors name @p name, line, key and what was expected.
[[nodiscard]] Result<AlarmLimits> parseAlarmLimits(std::string_view text, const std::string& name);

/// Reads the limits from @p file; a missing file leaves all defaults.
[[nodiscard]] Result<AlarmLimits> readAlarmLimits(const std::filesystem::path& file);

}  // namespace leitstand
