#include "core/mission/finds/victim_tags.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/mission/state/mission_state.h"
#include "tests/core/mission/finds/told_book.h"

namespace leitstand::test {
namespace {

GivenCue tagOf(const std::string& text, const Eigen::Vector3d& place = {2.0, 1.0, 0.1}) {
    return {.kind = "code", .place = place, .confidence = 0.95, .text = text};
}

TEST(VictimTags, ArePatternsOfWhatCodesSay) {
    EXPECT_TRUE(isVictimTag("V-01", usualTags()));
    EXPECT_TRUE(isVictimTag("V-117b", usualTags()));
    for (const char* other : {"", "V-", "V-x1", "v-01", "yellow-1", "xV-01", "V_01"})
        EXPECT_FALSE(isVictimTag(other, usualTags())) << other;
    EXPECT_TRUE(isVictimTag("victim 7 of 9", {"V-#*", "victim*"}));
    EXPECT_TRUE(isVictimTag("doll?", {"d?ll?"}));
    EXPECT_TRUE(isVictimTag("a-b-c", {"*-c"}));
    EXPECT_FALSE(isVictimTag("anything", {}));
    EXPECT_FALSE(isVictimTag("anything", {""}));
    EXPECT_FALSE(isVictimTag(std::string(100'000, 'a'), {"*a*a*a*b"})) << "and takes no time";
}

TEST(VictimTags, AVictimThatIsColdAndStillIsToldByItsTagAlone) {
    TestedBook book;
    book.give(tagOf("V-04"), 2);
    EXPECT_TRUE(book.victims().empty()) << "a glimpse is not enough";
    book.give(tagOf("V-04"), 2);
    book.pass(2.0);
    ASSERT_EQ(book.victims().size(), 1U);
    const CandidateSample reported = book.victims().front();
    EXPECT_LT((reported.positionInMap - Eigen::Vector3d(2.0, 1.0, 0.1)).norm(), 1e-6);
    EXPECT_NEAR(reported.confidence, 0.6, 0.01) << "just worth a look";
    EXPECT_GT(reported.deviation, 0.2) << "its tag is not its middle";
    ASSERT_EQ(reported.cues.size(), 1U);
    EXPECT_EQ(reported.cues.front().kind, "tag");
    EXPECT_EQ(reported.cues.front().text, "V-04");
}

TEST(VictimTags, OtherCodesAreNoVictims) {
    TestedBook book;
    book.give(tagOf("yellow-1"), 10);
    book.book.tags({});
    book.give(tagOf("V-01"), 10);
    EXPECT_TRUE(book.victims().empty());
    book.book.tags({"yellow-*"});
    book.give(tagOf("yellow-1"), 4);
    EXPECT_EQ(book.victims().size(), 1U) << "as the mission's profile says";
}

TEST(VictimTags, ATagBesideAPersonIsThatPersons) {
    TestedBook book;
    book.give({.place = {2.0, 1.0, 0.2}});
    book.give(tagOf("V-02", {2.4, 1.2, 0.1}), 6);
    book.pass(2.0);
    ASSERT_EQ(book.victims().size(), 1U);
    EXPECT_LT((book.victims().front().positionInMap - Eigen::Vector3d(2.0, 1.0, 0.2)).norm(), 0.05)
        << "where it is warm";
    TestedBook later;  // the tag first
    later.give(tagOf("V-02", {2.4, 1.2, 0.1}), 6);
    later.give({.place = {2.0, 1.0, 0.2}});
    later.pass(2.0);
    ASSERT_EQ(later.victims().size(), 1U);
    EXPECT_LT((later.victims().front().positionInMap - Eigen::Vector3d(2.0, 1.0, 0.2)).norm(), 0.05);
}

TEST(VictimTags, TwoTagsAreTwoVictimsHoweverNear) {
    TestedBook book;
    book.give(tagOf("V-01", {2.0, 1.0, 0.1}), 6);
    book.give(tagOf("V-02", {2.5, 1.0, 0.1}), 6);
    EXPECT_EQ(book.victims().size(), 2U);
}

TEST(VictimTags, ADollThatWavesAndIsNotWarmIsTold) {
    TestedBook book;
    book.give({.kind = "motion", .confidence = 0.8});
    EXPECT_TRUE(book.victims().empty());
    book.give(tagOf("V-05", {2.2, 1.0, 0.1}), 3);
    book.pass(2.0);
    ASSERT_EQ(book.victims().size(), 1U);
    EXPECT_GT(book.victims().front().confidence, 0.7);
}

TEST(VictimTags, WhatWasDismissedIsNotToldAgainByTheSameTag) {
    TestedBook book;
    book.give(tagOf("V-04"), 6);
    book.dismiss(book.victims().at(0).id);
    book.give(tagOf("V-04", {2.3, 1.5, 0.1}), 40);
    EXPECT_TRUE(book.victims().empty());
}

}  // namespace
}  // namespace leitstand::test
