#pragma once

#include "app/services/handin/report_content.h"

namespace leitstand {

class ReportSource;

/// Evidence and way of @p find; what cannot be fetched is told in @p warnings.
[[nodiscard]] FindPages pagesOf(const ReportFind& find, const ReportModel& model, ReportSource& source,
                                std::vector<std::string>& warnings);

}  // namespace leitstand
