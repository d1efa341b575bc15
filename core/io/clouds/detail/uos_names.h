#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace leitstand::detail {

/// Returns the number in a name "scanNNN.3d"; empty for other names.
[[nodiscard]] std::optional<std::size_t> uosNumber(const std::filesystem::path& file);

/// Returns "scan" and @p number with at least three digits.
[[nodiscard]] std::string uosName(std::size_t number);

}  // namespace leitstand::detail
