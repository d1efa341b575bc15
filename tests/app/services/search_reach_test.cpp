#include <gtest/gtest.h>

#include "app/services/victims/cue_finder.h"
#include "core/mission/coverage/coverage_settings.h"

namespace leitstand::test {

TEST(SearchReach, NothingCountsAsSearchedThatNobodyWouldLookFor) {
    const CueSettings looks;
    const CoverageSettings counts;
    EXPECT_LE(counts.cameraReach, looks.farthest);
    EXPECT_LE(counts.infraredReach, looks.farthestHeat);
}

}  // namespace leitstand::test
