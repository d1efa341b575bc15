#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace leitstand::detail {

/// A value of a YAML file and the line on which it stands.
struct YamlNode {
    enum class Kind { Null, Scalar, List, Map };
    Kind kind = Kind::Null;
    int line = 1;                   ///< from 1
    std::string scalar;             ///< of Scalar
    std::vector<YamlNode> items;    ///< of List, and the values of Map
    std::vector<std::string> keys;  ///< of Map: one for each item
    std::vector<int> keyLines;      ///< of Map: where each key stands
};

/// Reads one YAML document from a hostile place. Aliases, tags, other documents and control characters are
/// errors; depth and count of values are limited, so that neither time nor memory grow beyond the text's
/// size. Errors begin with @p name and the line.
[[nodiscard]] Result<YamlNode> parseYaml(std::string_view text, const std::string& name);

}  // namespace leitstand::detail
