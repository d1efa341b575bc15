#include "core/io/settings/station_file.h"

#include <set>
#include <string_view>

#include <gmock/gmock.h>

#include "core/event/station_samples.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

/// Version 4 of RFC 9562: x any digit, v 8, 9, a or b.
bool isRandomUuid(std::string_view text) {
    constexpr std::string_view Form = "xxxxxxxx-xxxx-4xxx-vxxx-xxxxxxxxxxxx", Digits = "0123456789abcdef";
    if (text.size() != Form.size()) return false;
    for (std::size_t i = 0; i < Form.size(); ++i) {
        const std::string_view allowed = Form[i] == 'x'   ? Digits
                                         : Form[i] == 'v' ? Digits.substr(8, 4)
                                                          : Form.substr(i, 1);
        if (allowed.find(text[i]) == std::string_view::npos) return false;
    }
    return true;
}

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
        EXPECT_TRUE(isRandomUuid(id)) << id;
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
