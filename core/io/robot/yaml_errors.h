#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "core/base/result.h"

namespace leitstand::detail {

/// @p text between quotes for an error: cut when long, control characters as \x1b.
[[nodiscard]] std::string shown(std::string_view text);
/// What stands at @p node, for an error: its text in quotes, "a list of 3", "keys and values", "nothing".
[[nodiscard]] std::string shown(const YAML::Node& node);
/// ", did you mean ...?" with the word of @p words that is nearly @p word; empty when none is.
[[nodiscard]] std::string likely(std::string_view word, const std::vector<std::string>& words);
/// "a, b or c"
[[nodiscard]] std::string anyOf(const std::vector<std::string>& words);

/// What is wrong with a file, gathered.
class YamlErrors {
public:
    explicit YamlErrors(std::string file) : m_file(std::move(file)) {}

    /// "kurt3d.yaml:14: streams[3].qos: expected ..., found ..."; @p line counts from 1.
    void add(int line, const std::string& path, const std::string& text);
    [[nodiscard]] bool empty() const { return m_lines.empty(); }
    /// A line for each, in the order of the file; of a hundred and more, the first hundred.
    [[nodiscard]] Error error() const;

private:
    std::string m_file;
    std::vector<std::pair<int, std::string>> m_lines;
    std::size_t m_untold = 0;
};

/// The line that @p node stands in, from 1.
[[nodiscard]] int lineOf(const YAML::Node& node);

}  // namespace leitstand::detail
