#include "core/io/yaml/yaml_fields.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "core/base/words.h"

namespace leitstand::detail {
namespace {

constexpr std::size_t LongestText = 128, LongestName = 64;  ///< [B]
constexpr std::size_t LongestRosName = 240;                 ///< [B]; DDS allows 255 with its own prefix

bool isLetterOrDigit(char c) {
    return c == '_' ||
           (static_cast<unsigned char>(c) < 0x80 && std::isalnum(static_cast<unsigned char>(c)) != 0);
}

bool isPrintable(std::string_view text) {
    return std::none_of(text.begin(), text.end(), [](char c) {
        const auto code = static_cast<unsigned char>(c);
        return code < 0x20 || code == 0x7F;
    });
}

std::string keyOf(const YAML::Node& node) {
    return node.IsScalar() ? node.Scalar() : std::string();
}

}  // namespace

bool isNumber(const YAML::Node& node, double& value) {
    if (!node.IsScalar()) return false;
    std::string_view text = node.Scalar();
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    double found = 0.0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), found);
    if (problem != std::errc() || end != text.data() + text.size() || !std::isfinite(found)) return false;
    value = found;
    return true;
}

bool isName(std::string_view text) {
    return !text.empty() && text.size() <= LongestName && isLetterOrDigit(text.front()) &&
           text.front() != '_' && std::isdigit(static_cast<unsigned char>(text.front())) == 0 &&
           std::all_of(text.begin(), text.end(), isLetterOrDigit);
}

bool isRosName(std::string_view text) {
    if (text.size() < 2 || text.size() > LongestRosName || text.front() != '/' || text.back() == '/')
        return false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char before = i == 0 ? 'x' : text[i - 1];
        if (!isLetterOrDigit(text[i]) && text[i] != '/') return false;
        if (before == '/' && (text[i] == '/' || (text[i] >= '0' && text[i] <= '9'))) return false;
        if (before == '_' && text[i] == '_') return false;  // reserved by ROS 2
    }
    return true;
}

YamlFields::YamlFields(const YamlPlace& place, std::span<const std::string_view> keys, YamlErrors& errors)
    : m_path(place.path), m_line(place.line), m_errors(&errors) {
    readEntries(place);
    if (!place.value.IsMap()) return;
    const std::vector<std::string> known(keys.begin(), keys.end());
    for (const auto& entry : place.value) {
        const std::string key = keyOf(entry.first);
        if (std::find(known.begin(), known.end(), key) != known.end()) continue;
        m_errors->add(
            lineOf(entry.first), m_path,
            leitstand::fill(translate("leitstand::Error", "expected one of the keys {}, found {}{}"),
                            anyOf(known), shown(entry.first), likely(key, known)));
    }
}

YamlFields::YamlFields(const YamlPlace& place, YamlErrors& errors)
    : m_path(place.path), m_line(place.line), m_errors(&errors) {
    readEntries(place);
    if (!place.value.IsMap()) return;
    for (const auto& entry : place.value) {
        const std::string key = keyOf(entry.first);
        if (isName(key)) continue;
        m_errors->add(lineOf(entry.first), m_path,
                      leitstand::fill(translate("leitstand::Error",
                                                "expected a name of at most {} letters, digits and _ that "
                                                "begins with a letter, found {}"),
                                      LongestName, shown(entry.first)));
        m_entries.erase(key);
    }
}

void YamlFields::readEntries(const YamlPlace& place) {
    if (!place.value.IsMap()) {
        m_errors->add(m_line, m_path,
                      leitstand::fill(translate("leitstand::Error", "expected keys and values, found {}"),
                                      shown(place.value)));
        return;
    }
    for (const auto& entry : place.value) {
        const int line = lineOf(entry.first);
        const std::string key = keyOf(entry.first);
        const auto [found, added] =
            m_entries.try_emplace(key, YamlPlace{entry.second, pathOf(isName(key) ? key : "?"), line});
        if (!added) {
            m_errors->add(line, m_path,
                          leitstand::fill(translate("leitstand::Error",
                                                    "expected each key once, found {} of line {} again"),
                                          shown(key), found->second.line));
        }
    }
}

std::string YamlFields::pathOf(std::string_view key) const {
    return m_path.empty() ? std::string(key) : m_path + "." + std::string(key);
}

YamlPlace YamlFields::at(std::string_view key) const {
    const auto found = m_entries.find(key);
    return found == m_entries.end() ? YamlPlace{YAML::Node(), pathOf(key), m_line} : found->second;
}

bool YamlFields::fail(std::string_view key, const std::string& text) const {
    const auto found = m_entries.find(key);
    m_errors->add(found == m_entries.end() ? m_line : found->second.line, pathOf(key), text);
    return false;
}

bool YamlFields::text(std::string_view key, std::string& value, bool maybeEmpty) const {
    if (!has(key)) return true;
    const YAML::Node node = at(key).value;
    if (!node.IsScalar() || node.Scalar().size() > LongestText || !isPrintable(node.Scalar()) ||
        (node.Scalar().empty() && !maybeEmpty)) {
        return fail(key,
                    leitstand::fill(translate("leitstand::Error",
                                              "expected a text of {} to {} printable characters, found {}"),
                                    maybeEmpty ? 0 : 1, LongestText, shown(node)));
    }
    value = node.Scalar();
    return true;
}

bool YamlFields::flag(std::string_view key, bool& value) const {
    if (!has(key)) return true;
    const YAML::Node node = at(key).value;
    const std::string word = keyOf(node);
    if (word != "true" && word != "false")
        return fail(key, leitstand::fill(translate("leitstand::Error", "expected true or false, found {}"),
                                         shown(node)));
    value = word == "true";
    return true;
}

bool YamlFields::number(std::string_view key, double& value, double least, double most,
                        const char* unit) const {
    if (!has(key)) return true;
    const YAML::Node node = at(key).value;
    double found = 0.0;
    if (!isNumber(node, found) || found < least || found > most)
        return fail(
            key, leitstand::fill(translate("leitstand::Error", "expected a number from {} to {}{}, found {}"),
                                 least, most, unit, shown(node)));
    value = found;
    return true;
}

bool YamlFields::count(std::string_view key, int& value, int least, int most) const {
    if (!has(key)) return true;
    const YAML::Node node = at(key).value;
    double found = 0.0;
    if (!isNumber(node, found) || found < least || found > most || found != std::floor(found))
        return fail(key, leitstand::fill(
                             translate("leitstand::Error", "expected a whole number from {} to {}, found {}"),
                             least, most, shown(node)));
    value = static_cast<int>(found);
    return true;
}

bool YamlFields::numbers(std::string_view key, std::vector<double>& values, std::size_t size, double most,
                         const char* unit) const {
    if (!has(key)) return true;
    const YAML::Node node = at(key).value;
    std::string odd = shown(node);
    bool right = node.IsSequence() && node.size() == size;
    std::vector<double> found(size, 0.0);
    for (std::size_t i = 0; right && i < size; ++i) {
        right = isNumber(node[i], found[i]) && std::abs(found[i]) <= most;
        if (!right) odd = shown(node[i]);
    }
    if (!right)
        return fail(key, leitstand::fill(
                             translate("leitstand::Error", "expected {} numbers from {} to {}{}, found {}"),
                             size, -most, most, unit, odd));
    values = std::move(found);
    return true;
}

std::size_t YamlFields::word(std::string_view key, const std::vector<std::string>& words) const {
    if (!has(key)) return words.size();
    const YAML::Node node = at(key).value;
    const std::string found = keyOf(node);
    const auto place = std::find(words.begin(), words.end(), found);
    if (place != words.end()) return static_cast<std::size_t>(place - words.begin());
    fail(key, leitstand::fill(translate("leitstand::Error", "expected {}, found {}{}"), anyOf(words),
                              shown(node), likely(found, words)));
    return words.size() + 1;
}

std::vector<YamlPlace> YamlFields::list(std::string_view key) const {
    std::vector<YamlPlace> places;
    if (!has(key)) return places;
    const YamlPlace place = at(key);
    if (!place.value.IsSequence()) {
        fail(key,
             leitstand::fill(translate("leitstand::Error", "expected a list, found {}"), shown(place.value)));
        return places;
    }
    for (const YAML::Node& node : place.value)
        places.push_back({node, fmt::format("{}[{}]", place.path, places.size()), lineOf(node)});
    return places;
}

}  // namespace leitstand::detail
