#include <filesystem>

#include <gtest/gtest.h>

#include "tests/app/robots/starts.h"
#include "tests/support/missing_tool.h"

namespace leitstand::test {
namespace {

/// Starts over a radio link.
class StartRadio : public testing::Test {
protected:
    void SetUp() override {
        if (const std::string why = whyNoNamespaces(); !why.empty()) {
            GTEST_SKIP() << "SKIPPED: the radio link needs network namespaces and TUN: " << why;
        }
    }
};
class StartStock : public StartRadio {
protected:
    void SetUp() override {
        StartRadio::SetUp();
        if (!std::filesystem::exists(program("cyclone_robot"))) {
            LEITSTAND_MISSING_TOOL(
                "Cyclone DDS was not found at build (Debian: cyclonedds-dev, cyclonedds-tools)");
        }
    }
};
using StartRadioLatency = StartRadio;
using StartRadioLong = StartRadio;
using StartStockLong = StartStock;

TEST(StartLatency, RobotRecorderAndStationHearEachOtherInWhateverOrderTheyStart) {
    Starts({.runs = 20}).run();
}

/// Over loopback all that a participant sends comes from one port, over a network it does not.
TEST_F(StartRadioLatency, WithKeysTheyHearEachOtherOverANetwork) {
    Starts({.runs = 4, .seed = 4, .atMost = 5.0, .keys = true, .loss = 0.001}).run();
}

TEST(StartLong, AHundredTimes) {
    Starts({.runs = 100, .seed = 2}).run();
}

TEST(StartLong, AHundredTimesWithKeys) {
    Starts({.runs = 100, .seed = 3, .atMost = 5.0, .keys = true}).run();
}

TEST_F(StartRadioLong, AHundredTimesWithOneInTwentyDatagramsLost) {
    Starts({.runs = 100, .seed = 5, .loss = 0.05}).run();
}

TEST_F(StartRadioLong, AHundredTimesWithKeysAndOneInTwentyDatagramsLost) {
    Starts({.runs = 100, .seed = 6, .atMost = 5.0, .keys = true, .loss = 0.05}).run();
}

TEST_F(StartStockLong, AHundredTimesWithACycloneRobot) {
    Starts({.runs = 100, .seed = 7, .stock = true}).run();
}

TEST(StartLong, AHundredTimesWithEndpointsThatAreAddedMeanwhile) {
    Starts({.runs = 100, .seed = 8, .added = true}).run();
}

}  // namespace
}  // namespace leitstand::test
