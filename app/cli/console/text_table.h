#pragma once

#include <string>
#include <vector>

namespace leitstand::cli {

/// Lays out @p rows of text in columns; the first row is the header. Columns of numbers are right-aligned,
/// others left-aligned. A column is as wide as its longest text, counted in UTF-8 characters.
[[nodiscard]] std::string textTable(const std::vector<std::vector<std::string>>& rows);

}  // namespace leitstand::cli
