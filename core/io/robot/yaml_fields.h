#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "core/io/robot/yaml_errors.h"

namespace leitstand::detail {

/// A value in a YAML file and its place.
struct YamlPlace {
    YAML::Node value;
    std::string path;  ///< "streams[3].qos"
    int line = 1;      ///< of its key, or of the value when it has no key
};

/// A map of a YAML file, read key by key with checks. A missing key leaves the value as it was. Every reading
/// function returns false when it reported an error, and true otherwise.
class YamlFields {
public:
    /// Reports an error when @p place is no map, has a key twice, or has a key that is not among @p keys. For
    /// an unknown key, the error suggests the likeliest of @p keys.
    YamlFields(const YamlPlace& place, std::span<const std::string_view> keys, YamlErrors& errors);
    /// Reads a map with keys of the user's choice, such as names of sensors: 1 to 64 letters, digits and _.
    YamlFields(const YamlPlace& place, YamlErrors& errors);

    [[nodiscard]] bool has(std::string_view key) const { return m_entries.contains(key); }
    /// Returns the place of @p key; when it is missing, a null value at the line of the map.
    [[nodiscard]] YamlPlace at(std::string_view key) const;
    /// All entries, by key.
    [[nodiscard]] const std::map<std::string, YamlPlace, std::less<>>& entries() const { return m_entries; }

    /// Reads printable text of 1 to 128 bytes (0 with @p maybeEmpty).
    bool text(std::string_view key, std::string& value, bool maybeEmpty = false) const;
    bool flag(std::string_view key, bool& value) const;
    /// Reads a finite number from @p least to @p most, in @p unit (" m"; may be empty).
    bool number(std::string_view key, double& value, double least, double most, const char* unit) const;
    bool count(std::string_view key, int& value, int least, int most) const;
    /// Reads @p size numbers, each between -@p most and @p most.
    bool numbers(std::string_view key, std::vector<double>& values, std::size_t size, double most,
                 const char* unit) const;
    /// Reads one of the words of @p choices.
    template <class T>
    bool choice(std::string_view key, T& value, const std::vector<std::pair<std::string, T>>& choices) const {
        std::vector<std::string> words;
        for (const auto& choice : choices) words.push_back(choice.first);
        const auto chosen = word(key, words);
        if (chosen < choices.size()) value = choices[chosen].second;
        return chosen <= choices.size();
    }
    /// Returns the entries of a list.
    [[nodiscard]] std::vector<YamlPlace> list(std::string_view key) const;

    /// Reports error @p text at @p key; returns false.
    bool fail(std::string_view key, const std::string& text) const;

private:
    void readEntries(const YamlPlace& place);
    [[nodiscard]] std::string pathOf(std::string_view key) const;
    /// Returns the index in @p words of the word at @p key; their number when @p key is missing, and more
    /// when it is wrong.
    [[nodiscard]] std::size_t word(std::string_view key, const std::vector<std::string>& words) const;

    std::map<std::string, YamlPlace, std::less<>> m_entries;
    std::string m_path;
    int m_line;
    YamlErrors* m_errors;
};

/// Reads the finite number that @p node holds; false when it holds none.
[[nodiscard]] bool isNumber(const YAML::Node& node, double& value);
/// Whether @p text names a robot, sensor, mode or action: 1 to 64 letters, digits and _, a letter first.
[[nodiscard]] bool isName(std::string_view text);

}  // namespace leitstand::detail
