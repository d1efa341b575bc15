#pragma once

#include <utility>
#include <vector>

#include <QString>

#include "core/mapping/map.h"
#include "widgets/models/scan_list_model.h"

namespace leitstand {

/// What stands in a column of the scans list for @p scan; a dash where a figure has no meaning.
[[nodiscard]] QString scanText(const MapScan& scan, ScanListModel::Column column);
/// What the figure is made of, for the tool tip.
[[nodiscard]] QString scanHint(const MapScan& scan, ScanListModel::Column column);
/// The head of a column, with its unit.
[[nodiscard]] QString columnTitle(ScanListModel::Column column);
/// What a column tells, in a sentence or two.
[[nodiscard]] QString columnHint(ScanListModel::Column column);

/// Caption and value.
using ScanDetail = std::pair<QString, QString>;
/// All there is to say about one scan, in reading order.
[[nodiscard]] std::vector<ScanDetail> scanDetails(const MapScan& scan);

}  // namespace leitstand
