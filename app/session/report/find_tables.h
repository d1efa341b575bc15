#pragma once

#include <vector>

#include "core/io/report/find_lists.h"
#include "core/io/report/search_list.h"
#include "core/mission/report/report_model.h"

namespace leitstand {

/// The confirmed finds of @p model as the list of @p kind: victims, QR codes, or all points of interest.
[[nodiscard]] FindList listOf(const ReportModel& model, FindList::Kind kind);
/// What was searched with each kind of sensor, and what was missed.
[[nodiscard]] std::vector<ListedSearch> searchListOf(const ReportModel& model);

}  // namespace leitstand
