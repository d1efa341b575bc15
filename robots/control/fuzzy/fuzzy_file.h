#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "robots/control/fuzzy/fuzzy_system.h"

namespace leitstand {

/// Reads a fuzzy system (YAML): `and`, `inputs` and `outputs` with `unit`, `range`, `terms`, and `rules` in
/// words. A term has three numbers (a triangle) or four (a trapezoid); "-inf" and "inf" make shoulders. A
/// rule: "if front is near and left is not near then turn is left, speed is slow with 0.8". The error lists
/// all that is wrong, a line each: file, line, key, expectation.
[[nodiscard]] Result<FuzzySystem> readFuzzySystem(const std::filesystem::path& file);
/// Parses the same from @p text; errors call it @p name.
[[nodiscard]] Result<FuzzySystem> parseFuzzySystem(std::string_view text, const std::string& name);
/// Parses one rule in words; does not look up its variables and terms.
[[nodiscard]] Result<FuzzyRule> parseFuzzyRule(const std::string& text);

}  // namespace leitstand
