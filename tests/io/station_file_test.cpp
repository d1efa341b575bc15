#include "core/io/station_file.h"

#include <regex>
#include <set>

#include <gmock/gmock.h>

#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

TEST(StationFile, IsMadeOnceAndKept) {
    const TemporaryFolder folder;
    const auto file = folder / "config/station.yaml";
    std::string id;
    {
        const auto station = StationFile::open(file, "Left desk");
        ASSERT_TRUE(station.ok()) << station.error().text;
        id = station->identity().id;
        EXPECT_EQ(station->identity().title, "Left desk");
        EXPECT_TRUE(station->identity().held.empty());
        EXPECT_EQ(station->warning(), "");
        EXPECT_TRUE(std::regex_match(
            id, std::regex("[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}")))
            << id;
        ASSERT_TRUE(
            station->remember({{driveGrant("kurt3d"), 1'700'000'001}, {{GrantSample::Kind::Map, ""}, 7}})
                .ok());
    }
    const auto again = StationFile::open(file, "Right desk");
    ASSERT_TRUE(again.ok()) << again.error().text;
    EXPECT_EQ(again->identity().id, id);
    EXPECT_EQ(again->identity().title, "Right desk");
    const std::vector<HeldGrant> held = {{driveGrant("kurt3d"), 1'700'000'001},
                                         {{GrantSample::Kind::Map, ""}, 7}};
    EXPECT_EQ(again->identity().held, held);
    ASSERT_TRUE(again->remember({}).ok());
}

TEST(StationFile, IdentitiesDiffer) {
    std::set<std::string> all;
    for (int i = 0; i < 1'000; ++i) all.insert(newStationId());
    EXPECT_EQ(all.size(), 1'000U);
}

TEST(StationFile, BelongsToOneProgramAtATime) {
    const TemporaryFolder folder;
    auto first = std::make_unique<Result<StationFile>>(StationFile::open(folder / "station.yaml", ""));
    ASSERT_TRUE(first->ok());
    const auto second = StationFile::open(folder / "station.yaml", "");
    ASSERT_FALSE(second.ok());
    EXPECT_THAT(second.error().text, HasSubstr("station.yaml"));
    EXPECT_THAT(second.error().text, HasSubstr("in use"));
    first.reset();
    EXPECT_TRUE(StationFile::open(folder / "station.yaml", "").ok());
}

TEST(StationFile, WhatCannotBeUnderstoodIsSetAside) {
    const TemporaryFolder folder;
    const auto file = folder / "station.yaml";
    for (const char* text : {"", "[", "station: ''", "station: [1, 2]", "grants: []", "station: \"a b\\nc\"",
                             "station: a\ngrants: 5", "station: a\ngrants: [{kind: fly, robot: k, term: 1}]",
                             "station: a\ngrants: [{kind: drive}]",
                             "station: a\ngrants: [{kind: drive, robot: k, term: -1}]", "\x01\x02\xff"}) {
        writeText(file, text);
        const auto station = StationFile::open(file, "");
        ASSERT_TRUE(station.ok()) << station.error().text;
        if (std::string(text) == "station: a\ngrants: 5") continue;  // no list: no grants
        EXPECT_THAT(station->warning(), HasSubstr("station.yaml.damaged")) << text;
        EXPECT_EQ(readText(folder / "station.yaml.damaged"), text);
        EXPECT_EQ(station->identity().id.size(), 36U);
    }
}

TEST(StationFile, SaysWhereItCannotBeWritten) {
    const auto station = StationFile::open("/proc/nowhere/station.yaml", "");
    ASSERT_FALSE(station.ok());
    EXPECT_THAT(station.error().text, HasSubstr("/proc/nowhere/station.yaml"));
}

}  // namespace
}  // namespace leitstand::test
