#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/station/alarms/alarm_rules.h"

namespace leitstand {

/// Parses the limits beyond which the operator is alarmed (YAML; docs/alarms.md, "Limits"). A limit that is
/// missing keeps its default. Errors have @p name, line, key and what was expected.
[[nodiscard]] Result<AlarmLimits> parseAlarmLimits(std::string_view text, const std::string& name);

/// Reads the limits from @p file. If the file is missing, all limits have their defaults.
[[nodiscard]] Result<AlarmLimits> readAlarmLimits(const std::filesystem::path& file);

}  // namespace leitstand
