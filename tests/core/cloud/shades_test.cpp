#include "core/cloud/shades.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(Shades, RiseWithTheIntensityWhateverItsUnit) {
    for (const float unit : {1.0F / 255.0F, 1.0F, 200.0F}) {
        std::vector<float> intensities;
        for (int i = 0; i <= 255; i += 5) intensities.push_back(static_cast<float>(i) * unit);
        const auto shades = shadesOf(intensities);
        EXPECT_TRUE(std::is_sorted(shades.begin(), shades.end())) << unit;
        EXPECT_GT(shades.back() - shades[1], 80) << unit;
    }
    EXPECT_EQ(shadesOf({255.0F}), shadesOf({1.0F})) << "a share of all";
}

TEST(Shades, OfNonsenseAreZeroOrTheHighest) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    EXPECT_THAT(shadesOf({nan, -1.0F, 0.0F, -inf, inf, 1e30F}), ElementsAre(0, 0, 0, 0, 255, 255));
    EXPECT_THAT(shadesOf({}), IsEmpty());
    EXPECT_THAT(shadesOf({nan, nan}), Each(0));
}

}  // namespace
}  // namespace leitstand
