#include "core/base/simd.h"

#include <cstdlib>

#include <gtest/gtest.h>

namespace leitstand {
namespace {

TEST(SimdDeathTest, TheEnvironmentForcesThePlainPath) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");  // a fresh process: the level is read once
    EXPECT_EXIT(
        {
            setenv("LEITSTAND_SIMD", "plain", 1);
            std::exit(simdLevel() == SimdLevel::Plain ? 0 : 1);
        },
        testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace leitstand
