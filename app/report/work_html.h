#pragma once

#include <QString>

#include "app/services/handin/report_content.h"

namespace leitstand {

/// Returns what was autonomous and what was computed where in this mission: on robots, on stations, by
/// people.
[[nodiscard]] QString workHtml(const ReportContent& content);

}  // namespace leitstand
