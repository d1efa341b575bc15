#pragma once

#include <QString>

#include "app/services/handin/report_content.h"

namespace leitstand {

/// What was searched with each kind of sensor, and the largest pieces of floor that were missed. Empty where
/// nobody knows of any floor.
[[nodiscard]] QString coverageHtml(const ReportContent& content);

}  // namespace leitstand
