#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "core/io/yaml/yaml_errors.h"

namespace leitstand::detail {

/// A value in a YAML file, and where it is written.
struct YamlPlace {
    YAML::Node value;
    std::string path;  ///< "streams[3].qos"
    int line = 1;      ///< line of the key; of the value when there is no key
};

/// Reads the keys of a YAML map one by one and checks them. If a key is missing, the value stays as it was.
/// Each reading function returns false when it reported an error, otherwise true.
class YamlFields {
public:
    /// Reports an error when @p place is no map, or has a key twice or one that is not among @p keys. For an
    /// unknown key, the error suggests the closest of @p keys.
    YamlFields(const YamlPlace& place, std::span<const std::string_view> keys, YamlErrors& errors);
    /// Reads a map whose keys the user chooses, such as names of sensors: 1 to 64 letters, digits and _.
    YamlFields(const YamlPlace& place, YamlErrors& errors);

    [[nodiscard]] bool has(std::string_view key) const { return m_entries.contains(key); }
    /// Returns the value of @p key and its place. When the key is missing, that is a null value at the line
    /// of the map.
    [[nodiscard]] YamlPlace at(std::string_view key) const;
    /// All values of the map by their keys.
    [[nodiscard]] const std::map<std::string, YamlPlace, std::less<>>& entries() const { return m_entries; }

    /// Reads printable text of 1 to 128 bytes (0 with @p maybeEmpty).
    bool text(std::string_view key, std::string& value, bool maybeEmpty = false) const;
    bool flag(std::string_view key, bool& value) const;
    /// Reads a finite number from @p least to @p most. @p unit is used in errors (" m"; may be empty).
    bool number(std::string_view key, double& value, double least, double most, const char* unit) const;
    bool count(std::string_view key, int& value, int least, int most) const;
    /// Reads @p size numbers, each between -@p most and @p most.
    bool numbers(std::string_view key, std::vector<double>& values, std::size_t size, double most,
                 const char* unit) const;
    /// Reads a word, which must be one of @p choices.
    template <class T>
    bool choice(std::string_view key, T& value, const std::vector<std::pair<std::string, T>>& choices) const {
        std::vector<std::string> words;
        words.reserve(choices.size());
        for (const auto& choice : choices) words.push_back(choice.first);
        const auto chosen = word(key, words);
        if (chosen < choices.size()) value = choices[chosen].second;
        return chosen <= choices.size();
    }
    /// Returns the entries of the list at @p key.
    [[nodiscard]] std::vector<YamlPlace> list(std::string_view key) const;

    /// Reports the error @p text at @p key. Returns false.
    bool fail(std::string_view key, const std::string& text) const;

private:
    void readEntries(const YamlPlace& place);
    [[nodiscard]] std::string pathOf(std::string_view key) const;
    /// Returns the index in @p words of the word at @p key. Returns the size of @p words when @p key is
    /// missing, and more when the word is wrong.
    [[nodiscard]] std::size_t word(std::string_view key, const std::vector<std::string>& words) const;

    std::map<std::string, YamlPlace, std::less<>> m_entries;
    std::string m_path;
    int m_line;
    YamlErrors* m_errors;
};

/// Reads the finite number that @p node holds into @p value; false when it holds none.
[[nodiscard]] bool isNumber(const YAML::Node& node, double& value);
/// Whether @p text can name a robot, sensor, mode or action: 1 to 64 letters, digits and _, beginning with a
/// letter.
[[nodiscard]] bool isName(std::string_view text);
/// Whether @p text can name a topic or service, such as "/kurt3d/left/image": up to 240 bytes; words of
/// letters, digits and _, with no digit first.
[[nodiscard]] bool isRosName(std::string_view text);

}  // namespace leitstand::detail
