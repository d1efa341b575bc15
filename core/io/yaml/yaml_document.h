#pragma once

#include <string>
#include <string_view>

#include <yaml-cpp/yaml.h>

#include "core/base/result.h"

namespace leitstand::detail {

/// Largest YAML file [B]; robot files have about 5 kB.
inline constexpr std::size_t LargestYaml = 256U << 10U;
inline constexpr int DeepestYaml = 16;  ///< largest depth of nested values

/// Parses the only YAML document of a file that may be untrusted. The file must be UTF-8, limited in size and
/// depth, and indented by spaces. Tags, anchors and aliases (which can expand to gigabytes) are refused. The
/// error has @p name, the line and what was expected.
[[nodiscard]] Result<YAML::Node> loadYaml(std::string_view text, const std::string& name);

}  // namespace leitstand::detail
