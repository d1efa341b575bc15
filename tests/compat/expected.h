#pragma once

#include <string>

#include <gtest/gtest.h>

namespace leitstand::test {

/// Whether @p found is what the file @p expected of tests/compat says: the same lines, numbers within
/// @p tolerance. The failure tells the first lines that differ. Where the environment has
/// LEITSTAND_COMPAT_FOUND, a folder, what was found is written there: the first expectation of a new fixture.
[[nodiscard]] testing::AssertionResult isAsExpected(const std::string& expected, const std::string& found,
                                                    double tolerance = 0.0);

}  // namespace leitstand::test
