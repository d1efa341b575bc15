#pragma once

#include <gtest/gtest.h>

namespace leitstand::test {

/// Whether a tool that packaging/debian-packages.txt installs has to be there: LEITSTAND_NO_SKIPS is set, as
/// packaging/leitstand does.
[[nodiscard]] bool toolsMustBeThere();

}  // namespace leitstand::test

/// Ends the test for want of a tool, which @p why names: skipped loudly, or failed where tools must be there.
#define LEITSTAND_MISSING_TOOL(why)                                                    \
    do {                                                                               \
        if (::leitstand::test::toolsMustBeThere()) GTEST_FAIL() << "MISSING: " << why; \
        GTEST_SKIP() << "SKIPPED: " << why;                                            \
    } while (false)
