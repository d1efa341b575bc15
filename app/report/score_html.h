#pragma once

#include <QString>

#include "app/services/handin/report_content.h"

namespace leitstand {

/// Returns a section about the estimated score: profile with its version, points of every find, penalties,
/// and values of the profile without a readable source. Empty without a profile.
[[nodiscard]] QString scoreHtml(const ReportContent& content);

}  // namespace leitstand
