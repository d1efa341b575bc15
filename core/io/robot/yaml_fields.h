#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <yaml-cpp/yaml.h>

namespace leitstand::detail {

/// What is wrong with a file, gathered.
struct YamlErrors {
    std::string file;
    std::vector<std::string> texts;

    /// "kurt3d.yaml:14: streams[3].qos: expected ..., found ..."
    void add(const YAML::Node& node, const std::string& path, const std::string& text);
};

/// A map of a YAML file, read key by key with checks; what is missing keeps the value it had.
class YamlFields {
public:
    /// Tells when @p node is no map, or has keys other than @p keys (with the likeliest of them).
    YamlFields(const YAML::Node& node, std::string path, std::initializer_list<std::string_view> keys,
               YamlErrors& errors);

    [[nodiscard]] bool has(const char* key) const { return m_node[key].IsDefined(); }
    void text(const char* key, std::string& value) const;
    void flag(const char* key, bool& value) const;
    /// A number from @p least to @p most.
    void number(const char* key, double& value, double least, double most) const;
    void count(const char* key, int& value, int least, int most) const;
    /// @p size numbers, each between -@p most and @p most.
    [[nodiscard]] std::vector<double> numbers(const char* key, std::size_t size, double most) const;
    /// One of the words of @p choices.
    template <class T>
    void choice(const char* key, T& value, const std::vector<std::pair<std::string, T>>& choices) const {
        std::string word;
        text(key, word);
        if (word.empty()) return;
        std::string expected;
        for (const auto& [name, meaning] : choices) {
            if (name == word) {
                value = meaning;
                return;
            }
            expected += (expected.empty() ? "" : ", ") + name;
        }
        fail(key, "expected one of " + expected + ", found \"" + word + "\"");
    }
    /// Calls @p read for each entry of a map (its key and path) or list (empty key).
    void each(const char* key, bool map,
              const std::function<void(const YAML::Node&, const std::string& key, const std::string& path)>&
                  read) const;

    void fail(const char* key, const std::string& text) const;
    [[nodiscard]] std::string pathOf(std::string_view key) const;

private:
    YAML::Node m_node;
    std::string m_path;
    YamlErrors* m_errors;
};

}  // namespace leitstand::detail
