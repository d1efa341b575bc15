#include "core/io/robot/yaml_fields.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <fmt/format.h>

namespace leitstand::detail {
namespace {

constexpr std::size_t LongestQuote = 40;

/// What stands there, for an error.
std::string quoted(const YAML::Node& node) {
    if (node.IsMap()) return "a map";
    if (node.IsSequence()) return fmt::format("a list of {}", node.size());
    if (!node.IsScalar()) return "nothing";
    const std::string& text = node.Scalar();
    return '"' + (text.size() > LongestQuote ? text.substr(0, LongestQuote) + "..." : text) + '"';
}

/// Levenshtein's distance.
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, replaced}));
        }
    }
    return row.back();
}

std::optional<double> asNumber(const YAML::Node& node) {
    try {
        if (node.IsScalar()) return node.as<double>();
    } catch (const YAML::Exception&) {  // told by the caller
    }
    return std::nullopt;
}

}  // namespace

void YamlErrors::add(const YAML::Node& node, const std::string& path, const std::string& text) {
    const int line = node.IsDefined() ? node.Mark().line : -1;
    const std::string place = line >= 0 ? fmt::format("{}:{}", file, line + 1) : file;
    texts.push_back(fmt::format("{}: {}{}{}", place, path, path.empty() ? "" : ": ", text));
}

YamlFields::YamlFields(const YAML::Node& node, std::string path, std::initializer_list<std::string_view> keys,
                       YamlErrors& errors)
    : m_node(node), m_path(std::move(path)), m_errors(&errors) {
    if (!node.IsMap()) {
        errors.add(node, m_path, "expected keys and values, found " + quoted(node));
        m_node = YAML::Node(YAML::NodeType::Map);
        return;
    }
    for (const auto& entry : node) {
        const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : std::string();
        if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
        const auto likely = std::min_element(
            keys.begin(), keys.end(),
            [&](std::string_view a, std::string_view b) { return distance(a, key) < distance(b, key); });
        std::string known;
        for (const std::string_view one : keys) known += (known.empty() ? "" : ", ") + std::string(one);
        const bool near = likely != keys.end() && distance(*likely, key) <= 1 + key.size() / 4;
        errors.add(entry.first, m_path,
                   fmt::format(
                       "unknown key {}{}", quoted(entry.first),
                       near ? fmt::format(", did you mean \"{}\"?", *likely) : "; expected one of " + known));
    }
}

std::string YamlFields::pathOf(std::string_view key) const {
    return m_path.empty() ? std::string(key) : m_path + "." + std::string(key);
}

void YamlFields::fail(const char* key, const std::string& text) const {
    const YAML::Node value = m_node[key];
    m_errors->add(value.IsDefined() ? value : m_node, pathOf(key), text);
}

void YamlFields::text(const char* key, std::string& value) const {
    if (!has(key)) return;
    if (m_node[key].IsScalar()) {
        value = m_node[key].Scalar();
    } else {
        fail(key, "expected a text, found " + quoted(m_node[key]));
    }
}

void YamlFields::flag(const char* key, bool& value) const {
    if (!has(key)) return;
    try {
        value = m_node[key].as<bool>();
    } catch (const YAML::Exception&) {
        fail(key, "expected true or false, found " + quoted(m_node[key]));
    }
}

void YamlFields::number(const char* key, double& value, double least, double most) const {
    if (!has(key)) return;
    const auto found = asNumber(m_node[key]);
    if (found && *found >= least && *found <= most) {
        value = *found;
    } else {
        fail(key, fmt::format("expected a number from {} to {}, found {}", least, most, quoted(m_node[key])));
    }
}

void YamlFields::count(const char* key, int& value, int least, int most) const {
    double number = value;
    this->number(key, number, least, most);
    if (number != std::floor(number))
        return fail(key, "expected a whole number, found " + quoted(m_node[key]));
    value = static_cast<int>(number);
}

std::vector<double> YamlFields::numbers(const char* key, std::size_t size, double most) const {
    std::vector<double> found;
    if (!has(key)) return found;
    const YAML::Node node = m_node[key];
    if (node.IsSequence() && node.size() == size) {
        for (const YAML::Node& one : node) {
            const auto number = asNumber(one);
            if (number && std::abs(*number) <= most) found.push_back(*number);
        }
    }
    if (found.size() == size) return found;
    fail(key,
         fmt::format("expected {} numbers between -{} and {}, found {}", size, most, most, quoted(node)));
    return {};
}

void YamlFields::each(const char* key, bool map,
                      const std::function<void(const YAML::Node&, const std::string& key,
                                               const std::string& path)>& read) const {
    if (!has(key)) return;
    const YAML::Node node = m_node[key];
    if (map ? !node.IsMap() : !node.IsSequence()) {
        return fail(key,
                    fmt::format("expected {}, found {}", map ? "keys and values" : "a list", quoted(node)));
    }
    std::size_t i = 0;
    for (const auto& entry : node) {
        if (map) {
            const std::string name = entry.first.IsScalar() ? entry.first.Scalar() : std::string();
            read(entry.second, name, pathOf(key) + "." + name);
        } else {
            read(entry, {}, fmt::format("{}[{}]", pathOf(key), i));
        }
        ++i;
    }
}

}  // namespace leitstand::detail
