#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace leitstand::test {

/// How many times longer than asked something may take (or less often than asked it may come) before a test
/// of latency fails. It runs on whatever computer builds the project: one that others use too, and of whose
/// two cores the simulated robots of the same test take more than one. Such a test prints what is asked and
/// what it saw.
constexpr double Generous = 2.0;

/// The least of @p values that a @p share (0..1) of them is not above (nearest rank); 0 where there are none.
inline double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
    return values[std::max<std::size_t>(rank, 1) - 1];
}

}  // namespace leitstand::test
