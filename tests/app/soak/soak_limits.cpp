#include "tests/app/soak/soak_limits.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

constexpr double Minutes = 60.0;
constexpr double MostMegabytes = 1200.0, AtKeyScans = 1400.0;

}  // namespace

std::chrono::duration<double> soakTime() {
    const char* reported = std::getenv("LEITSTAND_SOAK_MINUTES");
    return std::chrono::duration<double>(60.0 * (reported != nullptr ? std::atof(reported) : Minutes));
}

void expectFits(const Growth& growth) {
    ASSERT_GT(growth.keyScansLast, growth.keyScansFirst);
    const auto scans = static_cast<double>(growth.keyScansLast);
    const double aScan = (growth.last - growth.first) / (scans - static_cast<double>(growth.keyScansFirst));
    // How many there are depends on what the robots met: an hour has 1050 to 1400.
    const double atMany = growth.most + aScan * (AtKeyScans - scans);
    std::printf("%.0f key scans, %.2f MB each; %.0f MB would be %.0f key scans\n", scans, aScan, atMany,
                AtKeyScans);
    EXPECT_LE(aScan, MostMegabytesAScan);
    EXPECT_LE(std::max(growth.most, atMany), MostMegabytes);
}

}  // namespace leitstand::test
