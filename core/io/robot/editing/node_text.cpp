#include "core/io/robot/editing/node_text.h"

#include <algorithm>
#include <cstddef>

namespace leitstand::detail {
namespace {

/// Returns the offset of @p mark in @p text.
std::size_t placeOf(const std::string& text, const YAML::Mark& mark) {
    std::size_t at = 0;
    for (int i = 0; i < mark.line && at < text.size(); ++i) {
        const std::size_t end = text.find('\n', at);
        at = end == std::string::npos ? text.size() : end + 1;
    }
    return std::min(at + static_cast<std::size_t>(std::max(0, mark.column)), text.size());
}

/// Returns the end of the flow sequence or map that begins at @p begin; the size of @p text if it has none.
std::size_t endOfFlow(const std::string& text, std::size_t begin) {
    int depth = 0;
    char quote = 0;
    for (std::size_t i = begin; i < text.size(); ++i) {
        const char c = text[i];
        if (quote != 0) {
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '#' && i > 0 && (text[i - 1] == ' ' || text[i - 1] == '\n')) {
            i = std::min(text.find('\n', i), text.size() - 1);
        } else if (c == '[' || c == '{') {
            ++depth;
        } else if ((c == ']' || c == '}') && --depth == 0) {
            return i + 1;
        }
    }
    return text.size();
}

/// Returns the end of the plain scalar that begins at @p begin. @p inFlow: whether it stands in a flow map.
std::size_t endOfScalar(const std::string& text, std::size_t begin, bool inFlow) {
    std::size_t end = std::min(text.find('\n', begin), text.size());
    end = std::min({end, text.find(" #", begin), text.find("\t#", begin)});
    if (inFlow) end = std::min(end, text.find_first_of(",}", begin));
    while (end > begin && (text[end - 1] == ' ' || text[end - 1] == '\t' || text[end - 1] == '\r')) --end;
    return end;
}

/// Returns where the value of @p entry ends; npos: it is a block, or quoted.
std::size_t endOf(const std::string& text, const YAML::Node& value, bool inFlow) {
    const std::size_t begin = placeOf(text, value.Mark());
    if (begin >= text.size()) return std::string::npos;
    if (value.IsScalar()) {
        const bool quoted =
            text[begin] == '"' || text[begin] == '\'' || text[begin] == '|' || text[begin] == '>';
        return quoted ? std::string::npos : endOfScalar(text, begin, inFlow);
    }
    if (value.Style() != YAML::EmitterStyle::Flow || (text[begin] != '[' && text[begin] != '{'))
        return std::string::npos;
    return endOfFlow(text, begin);
}

}  // namespace

std::string withEntry(std::string text, const YAML::Node& map, const std::string& key,
                      const std::string& value) {
    if (!map.IsDefined() || !map.IsMap()) return {};
    const bool inFlow = map.Style() == YAML::EmitterStyle::Flow;
    for (const auto& entry : map) {
        if (entry.first.as<std::string>() != key) continue;
        const std::size_t begin = placeOf(text, entry.second.Mark()), end = endOf(text, entry.second, inFlow);
        if (end == std::string::npos || end < begin) return {};
        return text.replace(begin, end - begin, value);
    }
    const std::string line = key + ": " + value;
    if (inFlow) {
        const std::size_t brace = placeOf(text, map.Mark());
        if (brace >= text.size() || text[brace] != '{') return {};
        return text.insert(brace + 1, map.size() == 0 ? line : line + ", ");
    }
    if (map.size() == 0) return {};
    const YAML::Mark first = map.begin()->first.Mark();
    const std::string indent(static_cast<std::size_t>(std::max(0, first.column)), ' ');
    return text.insert(placeOf(text, first), line + "\n" + indent);
}

}  // namespace leitstand::detail
