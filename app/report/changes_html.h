#pragma once

#include <QString>

#include "app/services/handin/report_content.h"

namespace leitstand {

/// What came and what went since the missions before. Empty where the map is of one mission alone.
[[nodiscard]] QString changesHtml(const ReportContent& content);

}  // namespace leitstand
