#pragma once

#include <utility>
#include <vector>

#include <QString>

#include "core/mapping/map.h"
#include "widgets/models/scan_list_model.h"

namespace leitstand {

/// Returns the text for @p scan in a column of the list; a dash if a figure has no meaning.
[[nodiscard]] QString scanText(const MapScan& scan, ScanListModel::Column column);
/// Returns from what the figure is computed, for the tooltip.
[[nodiscard]] QString scanHint(const MapScan& scan, ScanListModel::Column column);
/// Returns the header of a column, with its unit.
[[nodiscard]] QString columnTitle(ScanListModel::Column column);
/// Returns what a column shows, in one or two sentences.
[[nodiscard]] QString columnHint(ScanListModel::Column column);

/// Caption and value.
using ScanDetail = std::pair<QString, QString>;
/// Returns all details of a scan, in reading order.
[[nodiscard]] std::vector<ScanDetail> scanDetails(const MapScan& scan);

}  // namespace leitstand
