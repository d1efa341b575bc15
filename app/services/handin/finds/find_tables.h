#pragma once

#include <vector>

#include "core/handin/report_model.h"
#include "core/io/handin/find_lists.h"
#include "core/io/handin/search_list.h"

namespace leitstand {

/// Returns the confirmed finds of @p model as a list of @p kind: victims, QR codes, or all points of
/// interest.
[[nodiscard]] FindList listOf(const ReportModel& model, FindList::Kind kind);
/// Returns what was searched with each kind of sensor, and what was missed, as a list.
[[nodiscard]] std::vector<ListedSearch> searchListOf(const ReportModel& model);

}  // namespace leitstand
