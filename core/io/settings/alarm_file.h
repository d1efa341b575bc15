#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/station/alarms/alarm_rules.h"

namespace leitstand {

/// Reads from where on the operator is told (docs/operator.md, "Alarms"): YAML; what is not named keeps its
/// default. Errors name @p name, line, key and what was expected.
[[nodiscard]] Result<AlarmLimits> parseAlarmLimits(std::string_view text, const std::string& name);

/// The same from @p file; a file that is not there names nothing.
[[nodiscard]] Result<AlarmLimits> readAlarmLimits(const std::filesystem::path& file);

}  // namespace leitstand
