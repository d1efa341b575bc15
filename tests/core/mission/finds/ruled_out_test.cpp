#include "core/mission/finds/ruled_out.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/mission/state/mission_state.h"
#include "tests/core/mission/finds/told_book.h"

namespace leitstand::test {
namespace {

TEST(RuledOut, AVictimBesideADismissedLampIsTold) {
    TestedBook book;
    book.give({.place = {2.0, 1.0, 0.2}});
    ASSERT_EQ(book.victims().size(), 1U);
    book.dismiss(1);
    book.give({.place = {2.0, 1.6, 0.2}});
    book.pass(2.0);
    ASSERT_EQ(book.victims().size(), 1U);
    EXPECT_NEAR(book.victims().front().positionInMap.y(), 1.6, 0.05);
}

TEST(RuledOut, TheLampItselfDoesNotComeBackThoughItIsSeenHereAndThere) {
    TestedBook book;
    book.give({.place = {2.0, 1.0, 0.2}});
    book.dismiss(1);
    book.updates = 0;
    for (int i = 0; i < 60; ++i) {
        const double angle = 2.4 * i, off = 0.05 * (i % 8);
        book.give(
            {.place = {2.0 + off * std::cos(angle), 1.0 + off * std::sin(angle), 0.2}, .deviation = 0.2}, 1);
    }
    // Some ranges are quite wrong, to either side.
    for (int i = 0; i < 8; ++i) book.give({.place = {2.0, i % 2 == 0 ? 1.5 : 0.5, 0.2}}, 1);
    book.pass(2.0);
    EXPECT_TRUE(book.victims().empty());
}

TEST(RuledOut, WarmthWhereOnlySomethingMovedIsNews) {
    TestedBook book;
    book.give({.kind = "motion", .confidence = 0.9});
    book.give({.kind = "code", .place = {2.2, 1.0, 0.2}, .confidence = 0.95, .text = "V-03"}, 4);
    ASSERT_EQ(book.victims().size(), 1U);
    book.dismiss(book.victims().at(0).id);
    book.give({.kind = "motion", .confidence = 0.9}, 30);
    EXPECT_TRUE(book.victims().empty()) << "what was dismissed";
    book.give({.kind = "heat", .confidence = 0.9});
    book.pass(2.0);
    EXPECT_EQ(book.victims().size(), 1U);
}

TEST(RuledOut, BesideAFindThatWasDiscardedThereMayBeAnother) {
    TestedBook book;
    book.give({.place = {2.0, 1.0, 0.2}});
    CandidateSample filed = book.reported.at(1);
    filed.victim = 4;
    filed.stamp += std::chrono::milliseconds(100);
    book.book.take(filed);
    book.give({.place = {2.0, 1.6, 0.2}});
    book.pass(2.0);
    EXPECT_EQ(book.reported.size(), 1U) << "while it stands, that is a part of it";
    book.book.discarded(FindSample::Kind::Victim, 4, true);
    book.give({.place = {2.0, 1.7, 0.2}}, 12);
    book.pass(2.0);
    ASSERT_EQ(book.reported.size(), 2U);
    EXPECT_NEAR(book.reported.at(2).positionInMap.y(), 1.7, 0.1);
    book.updates = 0;
    book.give({.place = {2.0, 1.0, 0.2}}, 30);
    EXPECT_EQ(book.reported.size(), 2U) << "the discarded one itself stays off";
}

TEST(RuledOut, WhatWasDismissedDoesNotBreathe) {
    TestedBook book;
    book.give({.place = {2.0, 1.0, 0.2}});
    book.dismiss(1);
    book.give({.place = {2.0, 1.8, 0.2}, .confidence = 0.6});
    const double before = book.victims().empty() ? 0.0 : book.victims().front().confidence;
    for (int i = 0; i < 20; ++i) {
        PlacedCue breath;
        breath.cue.kind = "co2";
        breath.cue.robot = "kurt3d";
        breath.cue.confidence = 1.0;
        breath.cue.stamp = TestedBook::at(book.time);
        breath.inMap = {2.0, 1.1, 0.3};
        breath.reach = 1.5;
        book.book.add(breath);
        book.pass(0.5);
    }
    ASSERT_EQ(book.victims().size(), 1U);
    EXPECT_GT(book.victims().front().confidence, before + 0.1) << "so the other one does";
}

}  // namespace
}  // namespace leitstand::test
