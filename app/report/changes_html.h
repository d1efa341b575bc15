#pragma once

#include <QString>

#include "app/services/handin/report_content.h"

namespace leitstand {

/// Returns a section about what appeared and disappeared since the earlier missions. Empty when nothing was
/// compared, as in a map of a single mission.
[[nodiscard]] QString changesHtml(const ReportContent& content);

}  // namespace leitstand
