#include "widgets/models/map/decision_text.h"

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

using Kind = MapDecision::Kind;

TEST(DecisionText, TellsOneScanByItsNumberAndManyByTheirCount) {
    EXPECT_EQ(decisionText({Kind::SetAside, {12}, 1}), "scan 12 set aside");
    EXPECT_EQ(decisionText({Kind::SetAside, {12, 13, 17}, 1}), "3 scans set aside");
    EXPECT_EQ(decisionText({Kind::Taken, {4}, 1}), "scan 4 accepted");
    EXPECT_EQ(decisionText({Kind::Tried, {4}, 1}), "scan 4 tried again");
    EXPECT_EQ(decisionText({Kind::Crop, {}, 1}), "what belongs into the map");
    EXPECT_EQ(decisionText({Kind::Loop, {}, 1}), "a closed loop");
    EXPECT_EQ(decisionText({Kind::Refused, {}, 1}), "two places kept apart");
}

}  // namespace
}  // namespace leitstand::test
