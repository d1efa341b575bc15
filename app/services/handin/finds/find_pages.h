#pragma once

#include "app/services/handin/report_content.h"

namespace leitstand {

class ReportSource;

/// Returns the evidence of @p find and the way to it; adds to @p warnings what cannot be read.
[[nodiscard]] FindPages pagesOf(const ReportFind& find, const ReportModel& model, ReportSource& source,
                                std::vector<std::string>& warnings);

}  // namespace leitstand
