#include "robots/control/fuzzy/fuzzy_system.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace leitstand {
namespace {

const FuzzySet* findSet(const std::map<std::string, FuzzyVariable>& variables, const FuzzyClause& clause) {
    const auto variable = variables.find(clause.variable);
    if (variable == variables.end()) return nullptr;
    const auto term = variable->second.terms.find(clause.term);
    return term == variable->second.terms.end() ? nullptr : &term->second;
}

}  // namespace

double FuzzySet::membership(double value) const {
    if (std::isnan(value)) return 0.0;
    if (value >= b && value <= c) return 1.0;
    if (value < b) return value <= a || !std::isfinite(a) ? 0.0 : (value - a) / (b - a);
    return value >= d || !std::isfinite(d) ? 0.0 : (d - value) / (d - c);
}

int FuzzyResult::strongest() const {
    const auto most = std::max_element(strengths.begin(), strengths.end());
    return most == strengths.end() || *most <= 0.0 ? -1 : static_cast<int>(most - strengths.begin());
}

double FuzzySystem::strength(const FuzzyRule& rule, const FuzzyValues& values) const {
    double strength = 1.0;
    for (const FuzzyClause& clause : rule.conditions) {
        const FuzzySet* set = findSet(inputs, clause);
        const auto value = values.find(clause.variable);
        if (set == nullptr || value == values.end() || std::isnan(value->second)) return 0.0;
        const double member = set->membership(value->second);
        const double fulfilled = clause.negated ? 1.0 - member : member;
        strength = conjunction == And::Minimum ? std::min(strength, fulfilled) : strength * fulfilled;
    }
    return strength * rule.weight;
}

FuzzyResult FuzzySystem::infer(const FuzzyValues& values) const {
    FuzzyResult result;
    result.strengths.reserve(rules.size());
    for (const FuzzyRule& rule : rules) result.strengths.push_back(strength(rule, values));
    for (const auto& [name, output] : outputs) {
        double area = 0.0, moment = 0.0;
        for (int i = 0; i <= resolution; ++i) {
            const double value = output.low + (output.high - output.low) * i / resolution;
            double highest = 0.0;
            for (std::size_t r = 0; r < rules.size(); ++r) {
                if (result.strengths[r] <= highest) continue;
                for (const FuzzyClause& clause : rules[r].conclusions) {
                    if (clause.variable != name) continue;
                    const FuzzySet* set = findSet(outputs, clause);
                    if (set == nullptr) continue;
                    const double member = set->membership(value);
                    highest =
                        std::max(highest, conjunction == And::Minimum ? std::min(member, result.strengths[r])
                                                                      : member * result.strengths[r]);
                }
            }
            area += highest;
            moment += highest * value;
        }
        result.outputs[name] = area > 1e-9 ? moment / area : std::clamp(0.0, output.low, output.high);
    }
    return result;
}

}  // namespace leitstand
