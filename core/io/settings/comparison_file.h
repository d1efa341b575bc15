#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/mapping/comparison/map_comparison.h"

namespace leitstand {

/// What registering a mission's key scans again made of them, as YAML: settings, figures and where each scan
/// came to be. Points are the mission's own and not in it.
[[nodiscard]] std::string writeComparison(const MapComparison& comparison);
/// The way back: scans have ids, poses and fits, but neither robot nor points; sums are as of sumUp(). @p
/// name of the file stands in errors with the line and what was expected.
[[nodiscard]] Result<MapComparison> parseComparison(std::string_view text, const std::string& name);

/// Errors also: the file cannot be opened, or is too large to be one.
[[nodiscard]] Result<MapComparison> readComparison(const std::filesystem::path& file);
/// Whole or not at all. Errors: it cannot be written, or has more scans than could be read again.
[[nodiscard]] Result<void> saveComparison(const MapComparison& comparison, const std::filesystem::path& file);

}  // namespace leitstand
