#pragma once

#include <string>

#include <yaml-cpp/yaml.h>

namespace leitstand::detail {

/// Returns the YAML @p text with the entry "key: value" in @p map, a node of it, in place of an earlier entry
/// with that key. All else stays as written, comments included. Empty when the text is written in a way that
/// is not supported here: the caller compares what both texts mean.
[[nodiscard]] std::string withEntry(std::string text, const YAML::Node& map, const std::string& key,
                                    const std::string& value);

}  // namespace leitstand::detail
