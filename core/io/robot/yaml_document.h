#pragma once

#include <string>
#include <string_view>

#include <yaml-cpp/yaml.h>

#include "core/base/result.h"

namespace leitstand::detail {

inline constexpr std::size_t LargestYaml = 256U << 10U;  ///< [B]; robot files have some 5 kB
inline constexpr int DeepestYaml = 16;                   ///< levels

/// Parses the one YAML document of a file that a stranger may have written: UTF-8, limited in size and depth,
/// without tags, anchors and aliases (which can stand for gigabytes), indented by spaces. The error names
/// @p name, the line and what was expected.
[[nodiscard]] Result<YAML::Node> loadYaml(std::string_view text, const std::string& name);

}  // namespace leitstand::detail
