#pragma once

#include <string>
#include <vector>

namespace leitstand::cli {

/// Lays rows of text out in columns, the first row being the header; columns of numbers right-aligned, others
/// left-aligned; columns are as wide as their longest text (counted in UTF-8 characters).
[[nodiscard]] std::string textTable(const std::vector<std::vector<std::string>>& rows);

}  // namespace leitstand::cli
