#include "robots/control/driving/passed_heat.h"

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

/// @p pictures of a body at @p heat, from @p from.
void see(PassedHeat& passed, const Eigen::Vector3d& heat, const Eigen::Vector3d& from, int pictures = 4) {
    for (int i = 0; i < pictures; ++i) passed.see(heat, from);
}

TEST(PassedHeat, AFlickerIsNoBody) {
    PassedHeat passed;
    see(passed, {2.0, 0.0, 0.1}, {0.5, 0.0, 0.0}, 3);
    EXPECT_FALSE(passed.next({0.0, 0.0, 0.0}));
    passed.see({2.1, 0.1, 0.1}, {0.5, 0.0, 0.0});
    ASSERT_TRUE(passed.next({0.0, 0.0, 0.0}));
    EXPECT_NEAR(passed.next({0.0, 0.0, 0.0})->heat.x(), 2.05, 0.06);
}

TEST(PassedHeat, GoesToTheNearestFirstAndNotToWhereItHasBeen) {
    PassedHeat passed;
    see(passed, {2.0, 0.0, 0.1}, {0.5, 0.0, 0.0});
    see(passed, {5.0, 0.0, 0.1}, {3.5, 0.0, 0.0});
    EXPECT_EQ(passed.next({4.5, 0.0, 0.0})->heat.x(), 5.0);
    EXPECT_EQ(passed.next({0.0, 0.0, 0.0})->heat.x(), 2.0);
    passed.forget({2.3, 0.4, 0.0}, 1.0);
    EXPECT_EQ(passed.next({0.0, 0.0, 0.0})->heat.x(), 5.0);
    passed.forget({5.0, 0.0, 0.0}, 1.0);
    EXPECT_FALSE(passed.next({0.0, 0.0, 0.0}));
}

TEST(PassedHeat, IsLookedAtFromWhereItWasSeenWell) {
    PassedHeat passed;
    see(passed, {2.0, 0.0, 0.1}, {-0.4, 0.0, 0.0});
    see(passed, {2.0, 0.0, 0.1}, {0.4, 0.0, 0.0});
    see(passed, {2.2, 0.3, 0.1}, {1.9, 0.0, 0.0});
    EXPECT_EQ(passed.next({0.0, 0.0, 0.0})->from.x(), 0.4) << "neither from afar nor when it stood over it";
    EXPECT_EQ(passed.next({0.0, 0.0, 0.0})->heat.x(), 2.0);
}

TEST(PassedHeat, ABodyOneStoreyUpIsAnotherOneAndComesLater) {
    PassedHeat passed;
    see(passed, {2.0, 0.0, 2.7}, {0.5, 0.0, 2.6});
    see(passed, {5.0, 0.0, 0.1}, {3.5, 0.0, 0.0});
    see(passed, {2.1, 0.1, 0.1}, {0.5, 0.0, 0.0});
    EXPECT_EQ(passed.next({2.0, 0.0, 0.0})->heat.x(), 2.1);
    passed.forget({2.1, 0.1, 0.1}, 1.0);
    EXPECT_EQ(passed.next({2.0, 0.0, 0.0})->heat.x(), 5.0);
    EXPECT_EQ(passed.next({2.0, 0.0, 2.6})->heat.z(), 2.7);
}

TEST(PassedHeat, HoldsSomeBodiesOnly) {
    PassedHeat passed;
    for (int i = 0; i < 1'000; ++i) see(passed, {2.0 * i, 0.0, 0.1}, {0.0, 0.0, 0.0});
    EXPECT_EQ(passed.next({0.0, 0.0, 0.0})->heat.x(), 0.0);
    EXPECT_LT(passed.next({2'000.0, 0.0, 0.0})->heat.x(), 100.0);
}

}  // namespace
}  // namespace leitstand::test
