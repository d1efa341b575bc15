#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "robots/control/fuzzy/fuzzy_system.h"

namespace leitstand {

/// Reads a fuzzy system from a YAML file. Its keys are "and", "inputs" and "outputs" (with "unit", "range",
/// "terms"), and "rules". A term has three numbers (a triangle) or four (a trapezoid); "-inf" and "inf" make
/// shoulders. An example of a rule: "if front is near and left is not near then turn is left, speed is slow
/// with 0.8". The error has a line for each mistake: file, line, key and what was expected.
[[nodiscard]] Result<FuzzySystem> readFuzzySystem(const std::filesystem::path& file);
/// Parses a fuzzy system from @p text; errors call the file @p name.
[[nodiscard]] Result<FuzzySystem> parseFuzzySystem(std::string_view text, const std::string& name);
/// Parses one rule in words. Does not check its variables and terms.
[[nodiscard]] Result<FuzzyRule> parseFuzzyRule(const std::string& text);

}  // namespace leitstand
