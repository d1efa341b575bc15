#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "core/base/result.h"

namespace leitstand::detail {

/// Returns @p text in quotes, for an error message. Long text is cut; control characters are written as \x1b.
[[nodiscard]] std::string shown(std::string_view text);
/// Describes @p node for an error message: text in quotes, "a list of 3", "keys and values", "nothing".
[[nodiscard]] std::string shown(const YAML::Node& node);
/// Returns ", did you mean ...?" with the one of @p words that is closest to @p word; empty when none is
/// close.
[[nodiscard]] std::string likely(std::string_view word, const std::vector<std::string>& words);
/// Joins @p words: "a, b or c".
[[nodiscard]] std::string anyOf(const std::vector<std::string>& words);

/// Collects the errors of a file.
class YamlErrors {
public:
    explicit YamlErrors(std::string file) : m_file(std::move(file)) {}

    /// Adds an error such as "kurt3d.yaml:14: streams[3].qos: expected ..., found ...". @p line counts from
    /// 1.
    void add(int line, const std::string& path, const std::string& text);
    [[nodiscard]] bool empty() const { return m_lines.empty(); }
    /// Returns one error with a line for each mistake, in the order of the file. If there are more than a
    /// hundred, it has the first hundred and the number of the others.
    [[nodiscard]] Error error() const;

private:
    std::string m_file;
    std::vector<std::pair<int, std::string>> m_lines;
    std::size_t m_unreported = 0;
};

/// Returns the line of @p node, counted from 1.
[[nodiscard]] int lineOf(const YAML::Node& node);

}  // namespace leitstand::detail
