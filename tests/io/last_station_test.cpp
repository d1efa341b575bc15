#include "core/io/settings/last_station_file.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

TEST(LastStation, WhatWasRememberedComesBack) {
    const TemporaryFolder folder;
    const auto file = folder / "config" / "live.yaml";
    EXPECT_FALSE(readLastStation(file));
    const LastStation station{{"kurt3d", "/home/me/my \"rover\".yaml"},
                              7,
                              {"wlan0"},
                              {"192.168.0.7"},
                              "10.0.0.1:11811",
                              "/keys/one"};
    ASSERT_TRUE(writeLastStation(file, station).ok());
    EXPECT_EQ(readLastStation(file), station);
    const LastStation zero{{"kurt3d"}, 0};
    ASSERT_TRUE(writeLastStation(file, zero).ok());
    EXPECT_EQ(readLastStation(file)->domain, 0) << "somebody chose it against ROS_DOMAIN_ID";
    ASSERT_TRUE(writeLastStation(file, {{"crawler"}}).ok());
    EXPECT_FALSE(readLastStation(file)->domain.has_value()) << "ROS's environment counts the next time, too";
    EXPECT_EQ(readLastStation(file)->robots, std::vector<std::string>{"crawler"});
}

TEST(LastStation, AFileOfBeforePeersIsRead) {
    const TemporaryFolder folder;
    const auto file = folder / "live.yaml";
    std::ofstream(file) << "robots: [\"kurt3d\"]\ndomain: 7\ninterfaces: [\"lo\"]\nkeys: \"\"\n";
    const auto station = readLastStation(file);
    ASSERT_TRUE(station.has_value());
    EXPECT_EQ(station->domain, 7);
    std::ofstream(file) << "robots: [\"kurt3d\"]\ndomain: 0\ninterfaces: []\nkeys: \"\"\n";
    EXPECT_FALSE(readLastStation(file)->domain.has_value()) << "nobody had chosen it";
    EXPECT_TRUE(station->initialPeers.empty() && station->discoveryServer.empty());
}

TEST(LastStation, NonsenseIsNothing) {
    const TemporaryFolder folder;
    const auto file = folder / "live.yaml";
    for (const char* text : {"", "3", "robots: []", "robots: [a]\ndomain: 500\ninterfaces: []\nkeys: \"\"",
                             "robots: [a]\ndomain: x\ninterfaces: []\nkeys: \"\"", "{{{"}) {
        std::ofstream(file) << text;
        EXPECT_FALSE(readLastStation(file)) << text;
    }
    EXPECT_FALSE(writeLastStation(folder.path(), {{"a"}}).ok());
}

}  // namespace
}  // namespace leitstand::test
