#include "robots/control/fuzzy/fuzzy_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "core/io/yaml/yaml_document.h"
#include "core/io/yaml/yaml_errors.h"
#include "core/io/yaml/yaml_fields.h"

namespace leitstand {
namespace {

using detail::YamlErrors;
using detail::YamlFields;
using detail::YamlPlace;

constexpr double Largest = 1e6;  ///< of numbers in a file
constexpr std::array<std::string_view, 4> SystemKeys = {"and", "inputs", "outputs", "rules"};
constexpr std::array<std::string_view, 3> VariableKeys = {"unit", "range", "terms"};
constexpr std::size_t MostRules = 500;
constexpr std::size_t MostTerms = 32;

std::optional<double> asNumber(const YAML::Node& node) {
    if (!node.IsScalar()) return std::nullopt;
    const std::string& text = node.Scalar();
    if (text == "inf" || text == ".inf") return std::numeric_limits<double>::infinity();
    if (text == "-inf" || text == "-.inf") return -std::numeric_limits<double>::infinity();
    try {
        const auto number = node.as<double>();
        if (std::isfinite(number) && std::abs(number) <= Largest) return number;
    } catch (const YAML::Exception&) {  // reported by the caller
    }
    return std::nullopt;
}

std::optional<FuzzySet> readSet(const YAML::Node& node) {
    if (!node.IsSequence() || (node.size() != 3 && node.size() != 4)) return std::nullopt;
    std::vector<double> numbers;
    for (const YAML::Node& one : node) {
        const auto number = asNumber(one);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    if (numbers.size() == 3) numbers.insert(numbers.begin() + 1, numbers[1]);
    const bool shoulders = (std::isfinite(numbers[0]) || numbers[0] == numbers[1] || numbers[0] < 0.0) &&
                           (std::isfinite(numbers[1]) || !std::isfinite(numbers[0])) &&
                           (std::isfinite(numbers[2]) || !std::isfinite(numbers[3]));
    const bool halfOpen = (!std::isfinite(numbers[0]) && std::isfinite(numbers[1])) ||
                          (std::isfinite(numbers[2]) && !std::isfinite(numbers[3]));
    if (!std::is_sorted(numbers.begin(), numbers.end()) || !shoulders || halfOpen) return std::nullopt;
    return FuzzySet{numbers[0], numbers[1], numbers[2], numbers[3]};
}

void readVariable(const YamlPlace& place, const std::string& name,
                  std::map<std::string, FuzzyVariable>& variables, YamlErrors& errors) {
    const YamlFields fields(place, VariableKeys, errors);
    FuzzyVariable variable;
    variable.name = name;
    fields.text("unit", variable.unit, true);
    std::vector<double> range;
    if (!fields.has("range")) {
        errors.add(place.line, place.path, "expected a range: two numbers");
    } else if (fields.numbers("range", range, 2, Largest, "")) {
        variable.low = range[0];
        variable.high = range[1];
        if (!(range[0] < range[1])) fields.fail("range", "expected the lower number first");
    }
    if (fields.has("terms")) {
        const YamlFields terms(fields.at("terms"), errors);
        for (const auto& [word, term] : terms.entries()) {
            const auto set = readSet(term.value);
            if (!set) {
                errors.add(term.line, term.path,
                           "expected three or four rising numbers (both of a side may be -inf or inf)");
            } else if (variable.terms.size() < MostTerms) {
                variable.terms[word] = *set;
            }
        }
    } else {
        errors.add(place.line, place.path, "expected terms");
    }
    variables[name] = variable;
}

/// Adds an error when @p clause names an unknown variable or term.
void check(const FuzzyClause& clause, const std::map<std::string, FuzzyVariable>& variables, const char* kind,
           const YamlPlace& place, YamlErrors& errors) {
    const auto variable = variables.find(clause.variable);
    if (variable == variables.end()) {
        errors.add(place.line, place.path,
                   fmt::format("expected an {}, found {}", kind, detail::shown(clause.variable)));
    } else if (!variable->second.terms.contains(clause.term)) {
        std::vector<std::string> terms;
        for (const auto& term : variable->second.terms) terms.push_back(term.first);
        errors.add(place.line, place.path,
                   fmt::format("expected {} to be {}, found {}", clause.variable, detail::anyOf(terms),
                               detail::shown(clause.term)));
    }
}

void readRule(const YamlPlace& place, FuzzySystem& system, YamlErrors& errors) {
    auto rule = parseFuzzyRule(place.value.IsScalar() ? place.value.Scalar() : std::string());
    if (!rule) return errors.add(place.line, place.path, rule.error().text);
    for (const FuzzyClause& one : rule->conditions) check(one, system.inputs, "input", place, errors);
    for (const FuzzyClause& one : rule->conclusions) check(one, system.outputs, "output", place, errors);
    if (system.rules.size() < MostRules) system.rules.push_back(*rule);
}

/// Parses a clause: "front is not near".
Result<FuzzyClause> parseClause(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    const bool negated = words.size() == 4 && words[2] == "not";
    if ((words.size() != 3 && !negated) || words[1] != "is")
        return Error{fmt::format("expected \"variable is term\", found {}", detail::shown(text))};
    return FuzzyClause{words[0], words.back(), negated};
}

/// Returns the parts of @p text between occurrences of @p separator.
std::vector<std::string> split(const std::string& text, const std::string& separator) {
    std::vector<std::string> parts;
    std::size_t from = 0;
    for (auto at = text.find(separator); at != std::string::npos; at = text.find(separator, from)) {
        parts.push_back(text.substr(from, at - from));
        from = at + separator.size();
    }
    parts.push_back(text.substr(from));
    return parts;
}

}  // namespace

Result<FuzzyRule> parseFuzzyRule(const std::string& text) {
    FuzzyRule rule;
    rule.text = text;
    const auto then = text.find(" then ");
    if (!text.starts_with("if ") || then == std::string::npos)
        return Error{fmt::format("expected \"if ... then ...\", found {}", detail::shown(text))};
    std::string conclusions = text.substr(then + 6);
    if (const auto with = conclusions.rfind(" with "); with != std::string::npos) {
        std::istringstream in(conclusions.substr(with + 6));
        std::string rest;
        if (!(in >> rule.weight) || in >> rest || !(rule.weight >= 0.0 && rule.weight <= 1.0))
            return Error{
                fmt::format("expected a weight from 0 to 1, found \"{}\"", conclusions.substr(with + 6))};
        conclusions.resize(with);
    }
    for (const std::string& part : split(text.substr(3, then - 3), " and ")) {
        auto clause = parseClause(part);
        if (!clause) return clause.error();
        rule.conditions.push_back(*clause);
    }
    for (const std::string& part : split(conclusions, ",")) {
        auto clause = parseClause(part);
        if (!clause) return clause.error();
        if (clause->negated) return Error{fmt::format("expected no \"not\" after then, found \"{}\"", part)};
        rule.conclusions.push_back(*clause);
    }
    return rule;
}

Result<FuzzySystem> parseFuzzySystem(std::string_view text, const std::string& name) {
    auto document = detail::loadYaml(text, name);
    if (!document) return document.error();
    YamlErrors errors(name);
    FuzzySystem system;
    const YamlFields fields({*document, "", 1}, SystemKeys, errors);
    fields.choice<FuzzySystem::And>(
        "and", system.conjunction,
        {{"minimum", FuzzySystem::And::Minimum}, {"product", FuzzySystem::And::Product}});
    for (const auto& [key, variables] :
         {std::pair("inputs", &system.inputs), std::pair("outputs", &system.outputs)}) {
        if (!fields.has(key)) continue;
        const YamlFields named(fields.at(key), errors);
        for (const auto& [variable, place] : named.entries())
            readVariable(place, variable, *variables, errors);
    }
    for (const YamlPlace& place : fields.list("rules")) readRule(place, system, errors);
    if (!errors.empty()) return errors.error();
    if (system.inputs.empty() || system.outputs.empty() || system.rules.empty())
        return Error{name + ": expected inputs, outputs and rules"};
    return system;
}

Result<FuzzySystem> readFuzzySystem(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) return Error{file.string() + ": cannot be opened"};
    std::string text(detail::LargestYaml + 1, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
    return parseFuzzySystem(text, file.filename().string());
}

}  // namespace leitstand
