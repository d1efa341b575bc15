#pragma once

#include <QString>

#include "app/services/handin/report_content.h"

namespace leitstand {

/// Returns the estimate of the score: profile with its version, points of every find, penalties, and profile
/// values without a readable source. Empty without a profile.
[[nodiscard]] QString scoreHtml(const ReportContent& content);

}  // namespace leitstand
