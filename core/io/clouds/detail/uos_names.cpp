#include "core/io/clouds/detail/uos_names.h"

#include <fmt/format.h>

#include "core/io/detail/numbers.h"

namespace leitstand::detail {

std::optional<std::size_t> uosNumber(const std::filesystem::path& file) {
    const std::string stem = file.stem().string();
    if (file.extension() != ".3d" || !stem.starts_with("scan")) return std::nullopt;
    return toCount(std::string_view(stem).substr(4));
}

std::string uosName(std::size_t number) {
    return fmt::format("scan{:03}", number);
}

}  // namespace leitstand::detail
