#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "robots/control/fuzzy/fuzzy_system.h"

namespace leitstand {

/// Reads a fuzzy system (YAML): `and`, `inputs` and `outputs` with `unit`, `range`, `terms` (three numbers: a
/// triangle, four: a trapezoid; "-inf" and "inf" make shoulders), `rules` in words: "if front is near and
/// left is not near then turn is left, speed is slow with 0.8". What is wrong is told in one text, a line
/// each: file, line, key, expectation.
[[nodiscard]] Result<FuzzySystem> readFuzzySystem(const std::filesystem::path& file);
/// The same from @p text; errors call it @p name.
[[nodiscard]] Result<FuzzySystem> parseFuzzySystem(std::string_view text, const std::string& name);
/// One rule in words; its variables and terms are not looked up.
[[nodiscard]] Result<FuzzyRule> parseFuzzyRule(const std::string& text);

}  // namespace leitstand
