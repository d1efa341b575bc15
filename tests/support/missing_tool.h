#pragma once

#include <gtest/gtest.h>

namespace leitstand::test {

/// Whether a tool that packaging/debian-packages.txt installs has to be there: LEITSTAND_NO_SKIPS is set, as
/// packaging/leitstand does.
[[nodiscard]] bool toolsMustBeThere();

/// Exit codes of what runs programs that we did not write, where the program is not installed, and where what
/// it needs cannot be fetched from the network.
inline constexpr int NotInstalled = 77, NotReachable = 78;

}  // namespace leitstand::test

/// Ends the test for want of a tool, which @p why names: skipped loudly, or failed where tools must be there.
#define LEITSTAND_MISSING_TOOL(why)                                                    \
    do {                                                                               \
        if (::leitstand::test::toolsMustBeThere()) GTEST_FAIL() << "MISSING: " << why; \
        GTEST_SKIP() << "SKIPPED: " << why;                                            \
    } while (false)

/// Ends the test where @p outcome, a ProcessOutcome, tells that its program is not installed; skips it,
/// loudly, where the network did not give what it needs: that is no fault of ours.
#define LEITSTAND_NEEDS(outcome)                                                                          \
    do {                                                                                                  \
        if ((outcome).exitCode == ::leitstand::test::NotReachable)                                        \
            GTEST_SKIP() << "SKIPPED: " << (outcome).err;                                                 \
        if ((outcome).exitCode == ::leitstand::test::NotInstalled) LEITSTAND_MISSING_TOOL((outcome).err); \
    } while (false)
