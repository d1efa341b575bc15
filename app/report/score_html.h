#pragma once

#include <QString>

#include "app/services/handin/report_content.h"

namespace leitstand {

/// The estimate of the score: profile with its version, what every find brings, penalties, and which values
/// of the profile nobody could confirm. Empty without a profile.
[[nodiscard]] QString scoreHtml(const ReportContent& content);

}  // namespace leitstand
