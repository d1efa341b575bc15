#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/io/clouds/uos.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/rooms.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

void writeRoomPair(const std::filesystem::path& folder) {
    for (int i = 0; i < 2; ++i) {
        RoomSettings settings;
        settings.sensorInRoom = poseFrom({-0.5 + 0.2 * i, 0, 0.9}, 0, 0, degrees(2.0 * i));
        settings.rows = 80;
        settings.columns = 120;
        settings.seed = static_cast<unsigned>(i + 1);
        Scan scan = scanRoom(settings).scan;
        scan.sensorInOdom = scan.sensorInOdom * poseFrom({0.03 * i, 0, 0}, 0, 0, 0);
        ASSERT_TRUE(writeUosScan(folder / fmt::format("scan{:03}.3d", i), scan));
    }
}

TEST(Table1Command, TellsAllFiveRowsBesideThePapers) {
    const TemporaryFolder folder;
    writeRoomPair(folder.path());
    const auto run = runProcess(program("leitstandctl"),
                                {"table1", folder.path().string(), "--json", "--repetitions", "1"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const json rows = json::parse(run.out)["rows"];
    ASSERT_EQ(rows.size(), 5u);
    EXPECT_TRUE(rows[0]["paper"]["seconds"].is_null()) << "several hours";
    EXPECT_EQ(rows[1]["paper"]["seconds"], 35.43);
    EXPECT_EQ(rows[4]["paper"]["iterations"], 34);
    EXPECT_EQ(rows[0]["iterations"], rows[1]["iterations"]);
    for (const json& row : rows) EXPECT_GT(row["seconds"], 0.0);

    const auto text =
        runProcess(program("leitstandctl"), {"table1", folder.path().string(), "--repetitions", "1"});
    EXPECT_EQ(text.exitCode, 0);
    EXPECT_THAT(text.out, HasSubstr("several hours"));
    EXPECT_THAT(text.out, HasSubstr("semantic forest of apx. kd-trees"));
}

TEST(Table1Command, WantsTwoOrganisedScans) {
    const TemporaryFolder folder;
    writeText(folder / "a.xyz", "1 2 3\n4 5 6\n7 8 10\n");
    const std::string file = (folder / "a.xyz").string();
    const auto one = runProcess(program("leitstandctl"), {"table1", file});
    EXPECT_EQ(one.exitCode, 1);
    EXPECT_THAT(one.err, HasSubstr("takes two scans, found 1"));
    const auto loose = runProcess(program("leitstandctl"), {"table1", file, file});
    EXPECT_EQ(loose.exitCode, 1);
    EXPECT_THAT(loose.err, HasSubstr("organised"));
    EXPECT_EQ(runProcess(program("leitstandctl"), {"table1"}).exitCode, 2);
}

}  // namespace
}  // namespace leitstand::test
