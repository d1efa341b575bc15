#pragma once

#include <QString>

#include "app/services/handin/report_content.h"

namespace leitstand {

/// Returns a section about what was autonomous in this mission, and what was computed on robots, on stations,
/// or done by people.
[[nodiscard]] QString workHtml(const ReportContent& content);

}  // namespace leitstand
