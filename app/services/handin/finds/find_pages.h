#pragma once

#include "app/services/handin/report_content.h"

namespace leitstand {

class ReportSource;

/// Returns the evidence of @p find and the way to it. Adds what cannot be read to @p warnings.
[[nodiscard]] FindPages pagesOf(const ReportFind& find, const ReportModel& model, ReportSource& source,
                                std::vector<std::string>& warnings);

}  // namespace leitstand
