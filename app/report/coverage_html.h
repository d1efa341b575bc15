#pragma once

#include <QString>

#include "app/services/handin/report_content.h"

namespace leitstand {

/// Returns a section about what was searched with each kind of sensor, and the largest regions of floor that
/// were missed. Empty when no floor is known.
[[nodiscard]] QString coverageHtml(const ReportContent& content);

}  // namespace leitstand
