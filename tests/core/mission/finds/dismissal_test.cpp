#include "core/mission/finds/dismissal.h"

#include <chrono>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

Time at(double seconds) {
    return Time(std::chrono::milliseconds(1'000'000 + static_cast<int>(1000.0 * seconds)));
}

/// A book of the station "us", what it told of each candidate last, and whether it told anything.
struct Reader {
    CandidateBook book{"us", CandidateSettings{}};
    std::map<std::uint32_t, CandidateSample> reported;
    int updates = 0;
    double time = 0.0;

    void see(double confidence = 0.9, int times = 8) {
        for (int i = 0; i < times; ++i) {
            PlacedCue cue;
            cue.cue.kind = "heat";
            cue.cue.robot = "kurt3d";
            cue.cue.confidence = confidence;
            cue.cue.stamp = at(time);
            cue.inMap = {2.0, 1.0, 0.2};
            cue.covariance = 0.0064 * Eigen::Matrix3d::Identity();
            book.add(cue);
            time += 0.5;
            for (const CandidateSample& one : book.due(at(time))) {
                reported[one.id] = one;
                ++updates;
            }
        }
    }
};

TEST(Dismissal, WhatAPersonDismissedDoesNotComeBackByTheSameCues) {
    Reader reader;
    reader.see();
    ASSERT_TRUE(reader.reported.contains(1));
    reader.book.take(judged(reader.reported[1], true, "us", at(reader.time + 0.1)));
    reader.updates = 0;
    reader.see(0.95, 60);
    EXPECT_EQ(reader.updates, 0) << "neither again nor under another number";
}

TEST(Dismissal, AWordThatCrossedWhatTheBookSaidStandsAndIsSaidOnceMore) {
    Reader reader;
    reader.see();
    const CandidateSample first = reader.reported.at(1);
    const CandidateSample word = judged(first, true, "us", first.stamp - std::chrono::milliseconds(1));
    reader.book.take(word);
    reader.updates = 0;
    reader.see(0.9, 20);
    EXPECT_EQ(reader.updates, 1);
    EXPECT_TRUE(isDismissal(reader.reported.at(1))) << "the log's newest says so again";
    reader.book.take(reader.reported.at(1));  // our own, back from the log
    reader.see(0.9, 20);
    EXPECT_EQ(reader.updates, 1);
}

TEST(Dismissal, TakenBackTheCandidateStandsAgain) {
    Reader reader;
    reader.see();
    const CandidateSample dismissed = judged(reader.reported.at(1), true, "us", at(reader.time + 0.1));
    reader.book.take(dismissed);
    reader.see(0.9, 4);
    reader.book.take(judged(dismissed, false, "us", at(reader.time + 0.1)));
    reader.see(0.3, 40);  // less sure: worth an update
    EXPECT_FALSE(isDismissal(reader.reported.at(1)));
    EXPECT_GT(reader.reported.at(1).stamp, dismissed.stamp) << "it is followed again";
}

TEST(Dismissal, ABooksOwnDoubtIsNone) {
    Reader reader;
    reader.see();
    CandidateSample doubted = reader.reported.at(1);
    doubted.dismissed = true;
    doubted.confidence = 0.3;
    EXPECT_FALSE(isDismissal(doubted)) << "taken back for want of evidence";
    CandidateSample joined = reader.reported.at(1);
    joined.dismissed = true;
    joined.cues.clear();
    EXPECT_FALSE(isDismissal(joined)) << "part of another one";
    EXPECT_TRUE(isDismissal(judged(doubted, true, "us", at(0.0)))) << "a person says so, however sure it is";
    EXPECT_FALSE(isDismissal(judged(doubted, false, "us", at(0.0))));
}

TEST(Dismissal, OutlastsARestart) {
    Reader first, second;
    first.see();
    second.book.take(judged(first.reported.at(1), true, "us", at(first.time)));
    second.see(0.95, 60);
    EXPECT_TRUE(second.reported.empty());
}

}  // namespace
}  // namespace leitstand::test
