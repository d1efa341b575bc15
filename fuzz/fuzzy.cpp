#include <algorithm>
#include <cmath>
#include <limits>

#include "fuzz/input_file.h"
#include "robots/control/fuzzy/fuzzy_file.h"

/// A file of fuzzy rules. What was read infers numbers from any values.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    const auto fuzzy = parseFuzzySystem({reinterpret_cast<const char*>(data), size}, "rules.yaml");
    if (!fuzzy) {
        fuzz::require(fuzzy.error().text.starts_with("rules.yaml:"), "an error that names its file");
        fuzz::require(fuzzy.error().text.size() < 100'000, "errors that can be read");
        return 0;
    }
    constexpr double Infinity = std::numeric_limits<double>::infinity();
    for (const double share : {0.0, 0.37, 1.0, -5.0, 1e300, Infinity, std::nan("")}) {
        FuzzyValues values;
        for (const auto& [name, input] : fuzzy->inputs)
            values[name] = std::lerp(input.low, input.high, share);
        const FuzzyResult result = fuzzy->infer(values);
        fuzz::require(result.strengths.size() == fuzzy->rules.size(), "a strength for each rule");
        for (const double strength : result.strengths) {
            fuzz::require(strength >= 0.0 && strength <= 1.0, "strengths from 0 to 1");
        }
        for (const auto& [name, value] : result.outputs) {
            const FuzzyVariable& output = fuzzy->outputs.at(name);
            fuzz::require(std::isfinite(value), "outputs that are numbers");
            fuzz::require(value >= std::min(output.low, 0.0) && value <= std::max(output.high, 0.0),
                          "outputs in their range");
        }
    }
    return 0;
}
