#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/mapping/comparison/map_comparison.h"

namespace leitstand {

/// Returns @p comparison as YAML: a mission's key scans that were registered again. It has settings, figures
/// and the poses of each scan. Points stay in the mission and are not included.
[[nodiscard]] std::string writeComparison(const MapComparison& comparison);
/// Parses the text of writeComparison(). Scans have ids, poses and fits, but neither robot nor points. The
/// sums come from sumUp(). Errors contain the file name @p name, the line and what was expected.
[[nodiscard]] Result<MapComparison> parseComparison(std::string_view text, const std::string& name);

/// Reads a comparison from @p file. Errors are those of parseComparison(), or that the file cannot be opened
/// or is too large.
[[nodiscard]] Result<MapComparison> readComparison(const std::filesystem::path& file);
/// Writes @p comparison completely or not at all. Error when @p file cannot be written, or when there are
/// more scans than readComparison() accepts.
[[nodiscard]] Result<void> saveComparison(const MapComparison& comparison, const std::filesystem::path& file);

}  // namespace leitstand
