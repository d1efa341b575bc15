#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace leitstand {

/// A fuzzy set: a trapezoid over a variable. Membership rises from a to b, is 1 to c, falls to d; b = c makes
/// a triangle, a = b or c = d a steep side; infinite a and b, or c and d, a shoulder.
struct FuzzySet {
    double a = 0.0, b = 0.0, c = 0.0, d = 0.0;
    [[nodiscard]] double membership(double value) const;
};

/// A quantity with its words.
struct FuzzyVariable {
    std::string name;  ///< "front"
    std::string unit;  ///< for readers
    double low = 0.0, high = 1.0;
    std::map<std::string, FuzzySet> terms;  ///< "near" ...
};

/// "front is not near": a condition or, without the not, a conclusion.
struct FuzzyClause {
    std::string variable, term;
    bool negated = false;
};

/// if all conditions then all conclusions.
struct FuzzyRule {
    std::string text;  ///< as it stands in the file
    std::vector<FuzzyClause> conditions, conclusions;
    double weight = 1.0;  ///< 0 to 1
};

/// Values of variables by name.
using FuzzyValues = std::map<std::string, double>;

/// What follows of values.
struct FuzzyResult {
    FuzzyValues outputs;                  ///< one an output; its fallback where no rule applies
    std::vector<double> strengths;        ///< how far each rule applies, 0 to 1
    [[nodiscard]] int strongest() const;  ///< rule that applies most; -1: none does
};

/// Fuzzy control after Mamdani: conditions joined by the minimum or the product, conclusions cut or scaled by
/// it, their union by the maximum, its centre of gravity taken.
struct FuzzySystem {
    enum class And : std::uint8_t { Minimum, Product };
    And conjunction = And::Minimum;
    std::map<std::string, FuzzyVariable> inputs, outputs;
    std::vector<FuzzyRule> rules;
    int resolution = 200;  ///< steps over an output's range, for the centre of gravity

    /// Infers all outputs. A missing input, or one that is no number, makes every rule of it say nothing.
    [[nodiscard]] FuzzyResult infer(const FuzzyValues& values) const;
    /// How far @p rule applies, with its weight.
    [[nodiscard]] double strength(const FuzzyRule& rule, const FuzzyValues& values) const;
};

}  // namespace leitstand
