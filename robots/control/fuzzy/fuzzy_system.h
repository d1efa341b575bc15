#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace leitstand {

/// A fuzzy set: a trapezoid over a variable. Membership rises from a to b, is 1 up to c, and falls to d. With
/// b = c it is a triangle. With a = b or c = d it has a vertical side. With infinite a and b, or c and d, it
/// has a shoulder.
struct FuzzySet {
    double a = 0.0, b = 0.0, c = 0.0, d = 0.0;
    [[nodiscard]] double membership(double value) const;
};

/// A quantity with its terms.
struct FuzzyVariable {
    std::string name;  ///< "front"
    std::string unit;  ///< for people who read the file
    double low = 0.0, high = 1.0;
    std::map<std::string, FuzzySet> terms;  ///< "near" ...
};

/// "front is not near": a condition, or (without "not") a conclusion.
struct FuzzyClause {
    std::string variable, term;
    bool negated = false;
};

/// If all conditions hold, all conclusions follow.
struct FuzzyRule {
    std::string text;  ///< text of the rule in the file
    std::vector<FuzzyClause> conditions, conclusions;
    double weight = 1.0;  ///< 0 to 1
};

/// Values of variables by name.
using FuzzyValues = std::map<std::string, double>;

/// The result of an inference.
struct FuzzyResult {
    /// A value for each output; if no rule applies, 0 or the nearest value in its range.
    FuzzyValues outputs;
    std::vector<double> strengths;        ///< how far each rule applies, 0 to 1
    [[nodiscard]] int strongest() const;  ///< index of the rule that applies most; -1: none
};

/// Mamdani's fuzzy control. Conditions are joined by the minimum or the product, which also cuts or scales
/// conclusions. Conclusions are united by the maximum; the output is their centre of gravity.
struct FuzzySystem {
    enum class And : std::uint8_t { Minimum, Product };
    And conjunction = And::Minimum;
    std::map<std::string, FuzzyVariable> inputs, outputs;
    std::vector<FuzzyRule> rules;
    /// Number of steps over the range of an output when its centre of gravity is computed.
    int resolution = 200;

    /// Infers all outputs. A rule with an input that is missing or NaN does not apply.
    [[nodiscard]] FuzzyResult infer(const FuzzyValues& values) const;
    /// Returns how far @p rule applies, 0 to 1: its conditions multiplied by its weight.
    [[nodiscard]] double strength(const FuzzyRule& rule, const FuzzyValues& values) const;
};

}  // namespace leitstand
