#include <cmath>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/io/clouds/tum.h"
#include "core/io/clouds/uos.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/rooms.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

ProcessOutcome leitstandctl(std::vector<std::string> arguments) {
    return runProcess(program("leitstandctl"), arguments);
}

/// Where the robot truly stood for each of the scans in writeRoomScans().
std::vector<Pose> truePoses() {
    return {poseFrom({-1.0, 0.0, 0.9}, 0, 0, 0), poseFrom({-0.5, 0.15, 0.9}, 0, 0, degrees(6)),
            poseFrom({0.0, 0.2, 0.9}, 0, 0, degrees(12))};
}

/// Three scans of a furnished room as a uos folder; the odometry of each is off by centimetres and a degree.
void writeRoomScans(const std::filesystem::path& folder) {
    const auto poses = truePoses();
    for (std::size_t i = 0; i < poses.size(); ++i) {
        RoomSettings settings;
        settings.sensorInRoom = poses[i];
        settings.rows = 116;
        settings.columns = 180;
        settings.seed = static_cast<unsigned>(i + 1);
        Scan scan = scanRoom(settings).scan;
        scan.sensorInOdom = poses[0].inverse() * poses[i] *
                            poseFrom({0.04 * double(i), -0.03 * double(i), 0}, 0, 0, degrees(double(i)));
        ASSERT_TRUE(writeUosScan(folder / fmt::format("scan{:03}.3d", i), scan));
    }
}

Pose poseOf(const json& scan) {
    Pose pose;
    for (int i = 0; i < 16; ++i) pose.matrix()(i / 4, i % 4) = scan["pose"][static_cast<std::size_t>(i)];
    return pose;
}

TEST(Register, FindsTheTruePosesOfARoomAndTellsThemAsJson) {
    const TemporaryFolder folder;
    writeRoomScans(folder.path());
    const auto run = leitstandctl({"register", folder.path().string(), "--json"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const json result = json::parse(run.out);
    ASSERT_EQ(result["scans"].size(), 3u);
    const auto truth = truePoses();
    for (std::size_t i = 0; i < 3; ++i) {
        const json& scan = result["scans"][i];
        EXPECT_EQ(scan["name"], fmt::format("scan{:03}", i));
        EXPECT_EQ(scan["points"], 116 * 180);
        EXPECT_TRUE(scan["converged"]);
        const Pose expected = truth[0].inverse() * truth[i];
        EXPECT_LT(distanceBetween(poseOf(scan), expected), 0.02) << scan["name"];
        EXPECT_LT(inDegrees(angleBetween(poseOf(scan), expected)), 0.3) << scan["name"];
    }
    EXPECT_GT(result["scans"][1]["iterations"], 0);
    EXPECT_GT(result["scans"][1]["overlap"], 0.5);
    EXPECT_GT(result["seconds"], 0.0);
}

TEST(Register, PrintsATableForPeople) {
    const TemporaryFolder folder;
    writeRoomScans(folder.path());
    const auto run =
        leitstandctl({"register", folder.path().string(), "--minimizer", "svd", "--threads", "1"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("scan002"));
    EXPECT_THAT(run.out, HasSubstr("reference"));
    EXPECT_THAT(run.out, HasSubstr("3 scans in"));
    EXPECT_EQ(run.err, "");
}

TEST(Register, WritesPosesThatServeAsTheGuessOfAnotherRun) {
    const TemporaryFolder folder;
    writeRoomScans(folder.path());
    const std::string poses = (folder / "poses.tum").string();
    ASSERT_EQ(leitstandctl({"register", folder.path().string(), "--poses", poses}).exitCode, 0);
    const auto read = readTum(poses);
    ASSERT_TRUE(read) << read.error().text;
    ASSERT_EQ(read->size(), 3u);
    const auto again = leitstandctl({"register", folder.path().string(), "--guess", poses, "--json"});
    ASSERT_EQ(again.exitCode, 0) << again.err;
    const json result = json::parse(again.out);
    EXPECT_LT(distanceBetween(poseOf(result["scans"][2]), (*read)[2].pose), 0.003);
    EXPECT_LE(result["scans"][2]["iterations"], 8) << "it started where it ended before";
}

TEST(Register, WritesTheMapAsOneCloudOrAsAFolderOfScans) {
    const TemporaryFolder folder;
    writeRoomScans(folder.path());
    for (const std::string ending : {"map.pcd", "map.ply", "map.xyz"}) {
        const std::string map = (folder / ending).string();
        ASSERT_EQ(leitstandctl({"register", folder.path().string(), "--map", map}).exitCode, 0) << ending;
        const auto again = leitstandctl({"register", map, "--json"});
        ASSERT_EQ(again.exitCode, 0) << again.err;
        EXPECT_GT(json::parse(again.out)["scans"][0]["points"], 40'000) << ending;
    }
    const std::string scans = (folder / "registered").string() + "/";
    ASSERT_EQ(leitstandctl({"register", folder.path().string(), "--map", scans}).exitCode, 0);
    const auto frames = readUosFrames(folder / "registered/scan002.frames");
    ASSERT_TRUE(frames) << frames.error().text;
    const auto truth = truePoses();
    EXPECT_LT(distanceBetween(frames->back().pose, truth[0].inverse() * truth[2]), 0.02);
}

TEST(Register, ABrokenScanIsNamedAndTheOthersStillRegister) {
    const TemporaryFolder folder;
    writeRoomScans(folder.path());
    writeText(folder / "scan001.3d", "1 2 3\n4 five 6\n");
    const auto run = leitstandctl({"register", folder.path().string(), "--json"});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.err, HasSubstr("scan001.3d:2: expected"));
    EXPECT_EQ(json::parse(run.out)["scans"].size(), 2u);
}

TEST(Register, UsageErrorsExitWithTwo) {
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{},
                                               {"regiser"},
                                               {"register"},
                                               {"register", "x", "--search", "octree"},
                                               {"register", "x", "--reduce", "-1"},
                                               {"register", "x", "--reduce", "nan"},
                                               {"register", "x", "--max-distance", "0.5,0"},
                                               {"register", "x", "--max-distance", "far"},
                                               {"register", "x", "--range", "5"},
                                               {"register", "x", "--range", "5", "4"},
                                               {"register", "x", "--max-iterations", "0"},
                                               {"register", "x", "--by-hand", "links.txt"},
                                               {"register", "x", "--unknown"}}) {
        const auto run = leitstandctl(words);
        EXPECT_EQ(run.exitCode, 2) << testing::PrintToString(words) << run.err;
        EXPECT_NE(run.err, "") << testing::PrintToString(words);
    }
}

TEST(Register, WhatCannotBeDoneExitsWithOneAndNamesTheFile) {
    const TemporaryFolder folder;
    const auto absent = leitstandctl({"register", (folder / "absent").string()});
    EXPECT_EQ(absent.exitCode, 1);
    EXPECT_THAT(absent.err, HasSubstr("absent"));
    writeRoomScans(folder.path());
    const auto guess =
        leitstandctl({"register", folder.path().string(), "--guess", (folder / "none.tum").string()});
    EXPECT_EQ(guess.exitCode, 1);
    EXPECT_THAT(guess.err, HasSubstr("none.tum"));
    writeText(folder / "two.tum", "0 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n");
    const auto few =
        leitstandctl({"register", folder.path().string(), "--guess", (folder / "two.tum").string()});
    EXPECT_EQ(few.exitCode, 1);
    EXPECT_THAT(few.err, HasSubstr("expected 3 poses, one a scan, found 2"));
    const auto unwritable =
        leitstandctl({"register", folder.path().string(), "--poses", (folder / "no/such/p.tum").string()});
    EXPECT_EQ(unwritable.exitCode, 1);
    EXPECT_THAT(unwritable.err, HasSubstr("p.tum"));
}

TEST(Register, RelaxesAllThatOverlapsWhereLoopsAreToBeClosed) {
    const TemporaryFolder folder;
    writeRoomScans(folder.path());
    const std::string poses = (folder / "poses.tum").string();
    const auto run =
        leitstandctl({"register", folder.path().string(), "--close-loops", "--json", "--poses", poses});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const json result = json::parse(run.out);
    const auto truth = truePoses();
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LT(distanceBetween(poseOf(result["scans"][i]), truth[0].inverse() * truth[i]), 0.01) << i;
    }
    const json& loops = result["loops"];
    EXPECT_TRUE(loops["closed"].empty()) << "it never came back";
    EXPECT_EQ(loops["matched"], 3);
    EXPECT_TRUE(loops["settled"]);
    EXPECT_NEAR(loops["rms_after"].get<double>(), loops["rms_before"].get<double>(), 1e-4)
        << "a chain this short lies as well before";
    const auto written = readTum(poses);
    ASSERT_TRUE(written) << written.error().text;
    EXPECT_TRUE(written->back().pose.isApprox(poseOf(result["scans"][2]), 1e-9))
        << "what is written is relaxed";
    const auto table = leitstandctl({"register", folder.path().string(), "--close-loops"});
    EXPECT_THAT(table.out, HasSubstr("0 loops closed; 3 of 3 scans fit what lies about them"));
    const auto plain = leitstandctl({"register", folder.path().string(), "--json"});
    EXPECT_FALSE(json::parse(plain.out).contains("loops"));
}

TEST(Register, WhatIsLinkedByHandPullsAsFarAsSurfacesLetIt) {
    const TemporaryFolder folder;
    writeRoomScans(folder.path());
    const auto last = [&](const std::string& line) {
        writeText(folder / "hand.txt", line);
        const auto run = leitstandctl({"register", folder.path().string(), "--close-loops", "--by-hand",
                                       (folder / "hand.txt").string(), "--json"});
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return poseOf(json::parse(run.out)["scans"][2]);
    };
    const Pose none = last(""), no = last("0 2 no\n"), far = last("0 2 1.3 0.2 0 0 0 0.1045 0.9945\n");
    EXPECT_TRUE(none.isApprox(no, 1e-9)) << "nothing was to be taken for the same place";
    EXPECT_GT(far.translation().x() - none.translation().x(), 1e-4) << "0.3 m too far on";
    EXPECT_LT(distanceBetween(far, none), 0.02) << "matches know better";
}

TEST(Register, NamesWhatIsWrongWithLinksByHand) {
    const TemporaryFolder folder;
    writeRoomScans(folder.path());
    const auto with = [&](const std::string& lines) {
        writeText(folder / "hand.txt", lines);
        return leitstandctl({"register", folder.path().string(), "--close-loops", "--by-hand",
                             (folder / "hand.txt").string()});
    };
    EXPECT_EQ(with("0 2 1.0 0.2 0 0 0 0.1045 0.9945\n1 2 no\n").exitCode, 0);
    const auto broken = with("0 2 no\n0 2 maybe\n");
    EXPECT_EQ(broken.exitCode, 1);
    EXPECT_THAT(broken.err, HasSubstr("hand.txt:2: expected i j tx ty tz qx qy qz qw, or i j no"));
    const auto beyond = with("0 3 no\n");
    EXPECT_EQ(beyond.exitCode, 1);
    EXPECT_THAT(beyond.err, HasSubstr("--by-hand: scan 3: expected one of the 3 scans, from 0"));
}

TEST(Register, CtrlCLeavesWhatWasFinished) {
    const TemporaryFolder folder;
    writeRoomScans(folder.path());
    const std::string poses = (folder / "poses.tum").string();
    // All points by brute force take minutes: the signal comes while the second scan is registered.
    const auto run = runAndInterrupt(
        program("leitstandctl"),
        {"register", folder.path().string(), "--reduce", "0", "--search", "brute-force", "--max-iterations",
         "100000", "--minimizer", "svd", "--json", "--poses", poses, "--threads", "1"},
        /*processorSeconds=*/2.0);
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.err, HasSubstr("interrupted: "));
    const std::size_t finished = json::parse(run.out)["scans"].size();
    EXPECT_GE(finished, 1u);
    const auto read = readTum(poses);
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->size(), finished);
}

TEST(Register, TheRealHallEndsAtTheConsensus) {
    LEITSTAND_HALL_OR_SKIP(hall);
    const auto run = leitstandctl({"register", hall.string(), "--json", "--reduce", "0", "--max-distance",
                                   "0.25", "--range", "0.48", "25"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const json result = json::parse(run.out);
    ASSERT_EQ(result["scans"].size(), 3u);
    const Pose first = poseOf(result["scans"][1]);
    const Pose second = first.inverse() * poseOf(result["scans"][2]);
    EXPECT_LT((first.translation() - Eigen::Vector3d(1.561930, 0.040855, -0.076320)).norm(), 0.03);
    EXPECT_LT((second.translation() - Eigen::Vector3d(1.829549, 0.020335, -0.060174)).norm(), 0.03);
}

}  // namespace
}  // namespace leitstand::test
