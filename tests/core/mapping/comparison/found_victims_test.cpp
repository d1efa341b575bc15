#include "core/mapping/comparison/found_victims.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

using Places = std::vector<Eigen::Vector3d>;

TEST(FoundVictims, EachFindIsAVictimOfItsOwn) {
    const Places victims = {{0, 0, 0}, {5, 0, 0}, {0, 5, 0}};
    const FindsError error = compareFinds(Places{{0.2, 0, 1}, {0.4, 0, 0}, {5, 0.1, 0}, {9, 9, 0}}, victims);
    EXPECT_EQ(error.finds, 4);
    EXPECT_EQ(error.found(), 2);
    EXPECT_EQ(error.missed, 1) << "nobody filed the third";
    EXPECT_EQ(error.wrong, 2) << "one was filed twice, one is nowhere";
    EXPECT_NEAR(error.mean, 0.15, 1e-9) << "seen from above";
    EXPECT_NEAR(error.worst, 0.2, 1e-9);
}

TEST(FoundVictims, AsManyAsCanBeAreFoundThoughANearerPairIsGivenUpForIt) {
    const FindsError error = compareFinds(Places{{0.0, 0, 0}, {0.5, 0, 0}}, Places{{0.4, 0, 0}, {1.3, 0, 0}});
    EXPECT_EQ(error.found(), 2);
    EXPECT_NEAR(error.worst, 0.8, 1e-9);
}

TEST(FoundVictims, NothingFiledIsAllMissedAndNothingThereIsAllWrong) {
    EXPECT_EQ(compareFinds(Places{}, Places{{1, 1, 0}}).missed, 1);
    EXPECT_EQ(compareFinds(Places{{1, 1, 0}}, Places{}).wrong, 1);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const FindsError strange = compareFinds(Places{{nan, 0, 0}, {1, 1, 0}}, Places{{1, 1, 0}, {nan, nan, 0}});
    EXPECT_EQ(strange.found(), 1);
    EXPECT_EQ(strange.missed, 1);
}

}  // namespace
}  // namespace leitstand::test
