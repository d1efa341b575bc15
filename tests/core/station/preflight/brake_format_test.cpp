#include "core/station/preflight/brake_format.h"

#include <gtest/gtest.h>

#include "core/base/words.h"
#include "core/station/preflight/brake_test.h"

namespace leitstand::test {
namespace {

/// A language of its own: what is translated is told from what is not.
std::string inBrackets(const char* /*context*/, const char* text) {
    return '[' + std::string(text) + ']';
}

/// What the window says of @p result, from what the log has.
std::string reported(const BrakeResult& result) {
    setTranslator(&inBrackets);
    std::string worded = brakeWorded(toString(result));
    setTranslator(nullptr);
    return worded;
}

TEST(BrakeSays, TheLogHasCodesAndTheWindowItsOwnLanguage) {
    BrakeResult passed;
    passed.verdict = BrakeResult::Verdict::Passed;
    passed.seconds = 0.312;
    passed.metres = 0.021;
    EXPECT_EQ(toString(passed), "brake_passed stood_ms=312 way_cm=2");
    EXPECT_EQ(reported(passed), "[brake test passed: it stood after 312 ms and 2 cm]");
    passed.verdict = BrakeResult::Verdict::Failed;
    EXPECT_EQ(reported(passed), "[brake test FAILED: without commands it still moved after 312 ms and 2 cm]");
    EXPECT_EQ(reported({}), "[brake not tested]");
}

TEST(BrakeSays, WhatTheWatchdogDoesIsTold) {
    BrakeResult result;
    result.verdict = BrakeResult::Verdict::Passed;
    result.watchdog = BrakeResult::Watchdog::Stops;
    result.seconds = 0.312;
    result.metres = 0.021;
    result.brakesAfter = 0.204;
    EXPECT_EQ(toString(result), "brake_passed braked_ms=204 stood_ms=312 way_cm=2");
    EXPECT_EQ(reported(result),
              "[brake test passed: without commands it braked after 204 ms and stood after 312 ms and 2 cm]");
    result.verdict = BrakeResult::Verdict::Failed;
    EXPECT_EQ(toString(result), "brake_failed braked_ms=204 stood_ms=312 way_cm=2");
    EXPECT_EQ(
        reported(result),
        "[brake test FAILED: without commands it braked after 204 ms and stood only after 312 ms and 2 cm]");
    result.watchdog = BrakeResult::Watchdog::None;
    EXPECT_EQ(toString(result), "brake_failed moved_ms=312 way_cm=2");
}

TEST(BrakeSays, EveryCauseIsToldInTheWindowsLanguage) {
    using Cause = BrakeResult::Cause;
    for (int cause = 0; cause <= static_cast<int>(Cause::OdometryEnded); ++cause) {
        BrakeResult result;
        result.verdict = BrakeResult::Verdict::Inconclusive;
        result.cause = static_cast<Cause>(cause);
        result.free = 0.4;
        result.needed = 1.2;
        const std::string text = reported(result);
        EXPECT_TRUE(text.starts_with("[brake test without result: [")) << text;
        EXPECT_TRUE(text.ends_with("]]")) << text;
        EXPECT_EQ(text.find("{}"), std::string::npos) << text;
    }
}

TEST(BrakeSays, SentencesOfOldLogsAreReadToo) {
    for (const char* sentence :
         {"brake not tested", "brake test passed: it stood after 312 ms and 2 cm",
          "brake test passed: without commands it braked after 204 ms and stood after 312 ms and 2 cm",
          "brake test FAILED: without commands it braked after 204 ms and stood only after 312 ms and 2 cm",
          "brake test FAILED: without commands it still moved after 312 ms and 2 cm"}) {
        setTranslator(&inBrackets);
        EXPECT_EQ(brakeWorded(sentence), '[' + std::string(sentence) + ']');
        EXPECT_EQ(brakeWorded("brake test without result: only 40 cm are free ahead, 120 cm are needed"),
                  "[brake test without result: [only 40 cm are free ahead, 120 cm are needed]]");
        EXPECT_EQ(brakeWorded("brake test without result: the key was let go"),
                  "[brake test without result: [the key was let go]]");
        setTranslator(nullptr);
    }
}

TEST(BrakeSays, NotesOfOthersStayAsTheyAre) {
    EXPECT_EQ(brakeWorded("brakes of the Crawler squeal"), "brakes of the Crawler squeal");
    EXPECT_EQ(brakeWorded(""), "");
}

}  // namespace
}  // namespace leitstand::test
