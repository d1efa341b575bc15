#include "core/robot/robot_format.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand::robot_format {
namespace {

std::string filled(std::string words, const std::string& value) {
    const auto gap = words.find("{}");
    return gap == std::string::npos ? words : words.replace(gap, 2, value);
}

TEST(RobotSays, WhatRobotsSayIsKnownAgain) {
    for (const char* words : All) {
        const auto parts = partsOf(filled(words, "0.40"));
        ASSERT_EQ(parts.size(), 1U) << words;
        ASSERT_NE(parts.front().words, nullptr) << words;
        EXPECT_STREQ(parts.front().words, words);
        EXPECT_EQ(parts.front().value, std::string(words).find("{}") == std::string::npos ? "" : "0.40");
    }
}

TEST(RobotSays, EverythingOnce) {
    const std::set<std::string> once(All.begin(), All.end());
    EXPECT_EQ(once.size(), All.size());
    for (const std::string& words : once) {
        EXPECT_EQ(words.find("; "), std::string::npos) << "would be taken apart: " << words;
        EXPECT_TRUE(words.find("{}") == words.rfind("{}")) << "one figure at most: " << words;
    }
}

TEST(RobotSays, SeveralThingsAtOnce) {
    const auto parts = partsOf("heat 1.20 m ahead; obstacle in 0.40 m; my own words; stopped by Tower 2");
    ASSERT_EQ(parts.size(), 4U);
    EXPECT_STREQ(parts[0].words, HeatAhead);
    EXPECT_EQ(parts[0].value, "1.20");
    EXPECT_STREQ(parts[1].words, Obstacle);
    EXPECT_EQ(parts[2].words, nullptr);
    EXPECT_EQ(parts[2].value, "my own words");
    EXPECT_STREQ(parts[3].words, StoppedBy);
    EXPECT_EQ(parts[3].value, "Tower 2");
}

TEST(RobotSays, RobotsOfOthersSayWhatTheyWant) {
    EXPECT_TRUE(partsOf("").empty());
    for (const std::string reported :
         {"{}", "stopped by ", "obstacle in  m", ";", "; ;", "s old", "\xff\xfe"}) {
        for (const Part& part : partsOf(reported)) EXPECT_EQ(part.words, nullptr) << reported;
    }
    EXPECT_EQ(partsOf(std::string(100'000, ';')).size(), 1U);
}

}  // namespace
}  // namespace leitstand::robot_format
