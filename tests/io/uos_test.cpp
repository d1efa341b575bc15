#include "core/io/clouds/uos.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/io/file_checks.h"
#include "tests/support/rooms.h"
#include "tests/support/shared_data.h"

namespace leitstand {
namespace {

using test::errorOf;
using test::expectSameScan;
using test::TemporaryFolder;
using test::written;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const char* const Pose = "0 0 0\n0 0 0\n";

TEST(UosScan, TurnsLeftHandedCentimetresIntoRightHandedMetres) {
    const TemporaryFolder folder;
    written(folder / "scan000.pose", Pose);
    const auto read = readUosScan(written(folder / "scan000.3d", "100 200 300\n-1.5 0 25\n"));
    ASSERT_TRUE(read.ok()) << errorOf(read);
    EXPECT_EQ(read->scan.name, "scan000");
    EXPECT_THAT(read->scan.points,
                ElementsAre(Eigen::Vector3f(3.0F, -1.0F, 2.0F), Eigen::Vector3f(0.25F, 0.015F, 0.0F)));
    EXPECT_FALSE(read->scan.organised());
    EXPECT_THAT(read->warnings, IsEmpty());
}

TEST(UosScan, TakesTheFourthNumberAsIntensity) {
    const TemporaryFolder folder;
    const auto read = readUosScan(written(folder / "scan000.3d", "1 2 3 0.5 red\n4 5 6 7 blue\n"));
    ASSERT_TRUE(read.ok()) << errorOf(read);
    EXPECT_THAT(read->scan.intensities, ElementsAre(0.5F, 7.0F));
}

TEST(UosScan, ToleratesHeadersCarriageReturnsAndBlankLines) {
    const TemporaryFolder folder;
    const auto read = readUosScan(written(
        folder / "scan000.3d", "# a scan\r\n2 x 2\r\n1 2 3\r\n\t4  5 6 \r\n7 8 9\r\n+1 1e1 -.5\r\n\r\n\n"));
    ASSERT_TRUE(read.ok()) << errorOf(read);
    EXPECT_EQ(read->scan.rows, 2);
    EXPECT_EQ(read->scan.columns, 2);
    EXPECT_EQ(read->scan.points.size(), 4U);
}

TEST(UosScan, TakesOriginAndNanAsNoEchoThatStaysInTheGrid) {
    const TemporaryFolder folder;
    const auto read = readUosScan(written(folder / "scan000.3d", "2 x 2\n0 0 0\n1 2 3\nnan 1 2\n4 5 6\n"));
    ASSERT_TRUE(read.ok()) << errorOf(read);
    EXPECT_TRUE(read->scan.points[0].array().isNaN().all());
    EXPECT_TRUE(read->scan.points[2].array().isNaN().all());
    EXPECT_TRUE(read->scan.organised());
}

TEST(UosScan, LoadsWithoutPoseAndWarns) {
    const TemporaryFolder folder;
    const auto read = readUosScan(written(folder / "scan000.3d", "1 2 3\n"));
    ASSERT_TRUE(read.ok()) << errorOf(read);
    EXPECT_FALSE(read->scan.hasOdometry);
    EXPECT_THAT(read->warnings, ElementsAre(HasSubstr("scan000.pose: is missing")));
}

TEST(UosScan, NamesFileLineAndExpectationOfWhatItCannotRead) {
    const TemporaryFolder folder;
    const auto errorFor = [&](const std::string& content) {
        return errorOf(readUosScan(written(folder / "scan001.3d", content)));
    };
    const std::string file = (folder / "scan001.3d").string();
    EXPECT_EQ(errorFor("1 2 3\nabc\n"), file + ":2: expected three numbers, found \"abc\"");
    EXPECT_EQ(errorFor("1 2\n"), file + ":1: expected three numbers, found \"1 2\"");
    EXPECT_THAT(errorFor("1 2 3\n1 2 3 4\n"), HasSubstr(":2: expected three numbers"));
    EXPECT_THAT(errorFor("1 2 3 4\n1 2 3\n"), HasSubstr(":2: expected 4 fields that begin with numbers"));
    EXPECT_THAT(errorFor("1 2 inf\n"), HasSubstr(":1: expected finite coordinates within 100 km"));
    EXPECT_THAT(errorFor("1 2 1e300\n"), HasSubstr(":1: expected finite coordinates within 100 km"));
    EXPECT_THAT(errorFor("1 2 1e400\n"), HasSubstr(":1: expected three numbers"));
    EXPECT_THAT(errorFor("1 2 3x\n"), HasSubstr(":1: expected three numbers"));
    EXPECT_THAT(errorFor(""), HasSubstr("scan001.3d: expected points, found none"));
    EXPECT_THAT(errorFor("# nothing\n\n"), HasSubstr("expected points, found none"));
    EXPECT_THAT(errorFor("2 x 2\n1 2 3\n"), HasSubstr("expected 4 points (2 x 2), found 1"));
    EXPECT_THAT(errorFor("2 x 0\n1 2 3\n"), HasSubstr(":1: expected three numbers, found \"2 x 0\""));
    EXPECT_THAT(errorFor(std::string("\x7f"
                                     "ELF\0\1\2\n",
                                     8)),
                HasSubstr("found \"\\x7fELF\\x00\\x01"));
    EXPECT_THAT(errorFor("1 2 3\n" + std::string(100'000, '7')), HasSubstr(":2: expected lines of at most"));
    EXPECT_THAT(errorFor("2147483647 x 2147483647\n1 2 3\n"), HasSubstr("found 1"));
}

TEST(UosScan, ReportsFilesThatCannotBeRead) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "scan000.3d");
    EXPECT_THAT(errorOf(readUosScan(folder / "scan000.3d")), HasSubstr("expected a file, found a directory"));
    std::filesystem::create_symlink("nowhere", folder / "scan001.3d");
    EXPECT_THAT(errorOf(readUosScan(folder / "scan001.3d")), HasSubstr("cannot be opened: No such file"));
    EXPECT_THAT(errorOf(readUosScan(folder / "scan002.3d")), HasSubstr("cannot be opened: No such file"));
}

TEST(UosScan, ReportsABrokenPose) {
    const TemporaryFolder folder;
    const auto scan = written(folder / "scan000.3d", "1 2 3\n");
    const auto errorFor = [&](const std::string& pose) {
        written(folder / "scan000.pose", pose);
        return errorOf(readUosScan(scan));
    };
    EXPECT_THAT(errorFor("1 2 3\n4 five 6\n"), HasSubstr("scan000.pose:2: expected six numbers"));
    EXPECT_THAT(errorFor("1 2 3\n4 5\n"), HasSubstr("found 5 numbers"));
    EXPECT_THAT(errorFor("1 2 3\n4 5 6 7\n"), HasSubstr(":2: expected six numbers"));
    EXPECT_THAT(errorFor("1 2 nan\n4 5 6\n"), HasSubstr(":1: expected six numbers"));
    EXPECT_THAT(errorFor("1 2 1e300\n4 5 6\n"), HasSubstr("expected a position within 100 km"));
    EXPECT_THAT(errorFor(""), HasSubstr("found 0 numbers"));
    std::filesystem::remove(folder / "scan000.pose");
    std::filesystem::create_symlink("nowhere", folder / "scan000.pose");
    EXPECT_THAT(errorOf(readUosScan(scan)), HasSubstr("scan000.pose: cannot be opened"));
}

TEST(UosPose, RotatesAboutXThenYThenZ) {
    const TemporaryFolder folder;
    // 90 degrees about their y (up) turns their forward z to their right x: a right turn, about our -z.
    const auto turned = readUosPose(written(folder / "scan000.pose", "10 20 30\n0 90 0\n"));
    ASSERT_TRUE(turned.ok()) << errorOf(turned);
    EXPECT_TRUE(turned->isApprox(poseFrom({0.3, -0.1, 0.2}, 0, 0, degrees(-90)), 1e-12));
    // R = Rx Ry Rz in their axes becomes our R(-y) R(z) R(x) with angles reversed: left-handed.
    const auto all = readUosPose(written(folder / "scan001.pose", "0 0 0\n10 20 30\n"));
    ASSERT_TRUE(all.ok()) << errorOf(all);
    const Eigen::Matrix3d expected = (Eigen::AngleAxisd(degrees(10), Eigen::Vector3d::UnitY()) *
                                      Eigen::AngleAxisd(degrees(-20), Eigen::Vector3d::UnitZ()) *
                                      Eigen::AngleAxisd(degrees(-30), Eigen::Vector3d::UnitX()))
                                         .toRotationMatrix();
    EXPECT_TRUE(all->linear().isApprox(expected, 1e-12));
}

TEST(UosPose, RoundTripsAnyPose) {
    const TemporaryFolder folder;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi);
    std::uniform_real_distribution<double> metres(-50.0, 50.0);
    for (int i = 0; i < 100; ++i) {
        // Every tenth one looks straight up or down, where Euler angles are not unique.
        const double pitch = i % 10 == 0 ? degrees(90) : angle(random) / 2.0;
        const auto pose =
            poseFrom({metres(random), metres(random), metres(random)}, angle(random), pitch, angle(random));
        ASSERT_TRUE(writeUosPose(folder / "a.pose", pose).ok());
        const auto back = readUosPose(folder / "a.pose");
        ASSERT_TRUE(back.ok()) << errorOf(back);
        EXPECT_TRUE(back->isApprox(pose, 1e-9)) << test::readText(folder / "a.pose");
    }
}

TEST(UosFrames, RoundTrip) {
    const TemporaryFolder folder;
    const std::vector<UosFrame> frames = {{poseFrom({1, 2, 3}, 0.1, 0.2, 0.3), 2},
                                          {poseFrom({-1, 0.5, 0}, -0.1, 1.2, 3.0), 1}};
    ASSERT_TRUE(writeUosFrames(folder / "a.frames", frames).ok());
    const auto back = readUosFrames(folder / "a.frames");
    ASSERT_TRUE(back.ok()) << errorOf(back);
    ASSERT_EQ(back->size(), 2U);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_TRUE((*back)[i].pose.isApprox(frames[i].pose, 1e-9));
        EXPECT_EQ((*back)[i].colour, frames[i].colour);
    }
}

TEST(UosFrames, AreColumnMajorLeftHandedCentimetres) {
    const TemporaryFolder folder;
    const auto frames =
        readUosFrames(written(folder / "a.frames", "1 0 0 0 0 1 0 0 0 0 1 0 10 20 30 1 2\n\n"));
    ASSERT_TRUE(frames.ok()) << errorOf(frames);
    EXPECT_TRUE(frames->back().pose.isApprox(poseFrom({0.3, -0.1, 0.2}, 0, 0, 0), 1e-12));
}

TEST(UosFrames, ReportsWhatIsNoRigidMotion) {
    const TemporaryFolder folder;
    const auto errorFor = [&](const std::string& content) {
        return errorOf(readUosFrames(written(folder / "a.frames", content)));
    };
    EXPECT_THAT(errorFor(""), HasSubstr("expected frames, found none"));
    EXPECT_THAT(errorFor("1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n"), HasSubstr(":1: expected a column-major 4x4"));
    EXPECT_THAT(errorFor("2 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 1\n"),
                HasSubstr(":1: expected a column-major 4x4"));
    EXPECT_THAT(errorFor("-1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 1\n"), HasSubstr("expected a column-major 4x4"));
    EXPECT_THAT(errorFor("1 0 0 0 0 1 0 0 0 0 1 0 0 0 nan 1 1\n"), HasSubstr("expected a column-major 4x4"));
    EXPECT_THAT(errorFor("1 0 0 0 0 1 0 0 0 0 1 0 0 0 1e300 1 1\n"),
                HasSubstr("expected a column-major 4x4"));
}

class UosRoom : public ::testing::TestWithParam<Sweep> {};

TEST_P(UosRoom, RoundTripsExactlyWithGridIntensitiesAndOdometry) {
    const TemporaryFolder folder;
    Scan scan = test::scanRoom({.sensorInRoom = poseFrom({0.5, 0.2, 1.0}, 0.02, -0.1, 0.4),
                                .sweep = GetParam(),
                                .rows = 40,
                                .columns = 90,
                                .seed = 3})
                    .scan;
    scan.intensities.resize(scan.points.size());
    for (std::size_t i = 0; i < scan.points.size(); ++i) scan.intensities[i] = 0.1F * static_cast<float>(i);
    scan.points[7] = Eigen::Vector3f::Constant(std::nanf(""));
    ASSERT_TRUE(writeUosScan(folder / "scan003.3d", scan).ok());

    const auto read = readUosScan(folder / "scan003.3d");
    ASSERT_TRUE(read.ok()) << errorOf(read);
    expectSameScan(read->scan, scan);
    EXPECT_TRUE(read->scan.hasOdometry);
    EXPECT_TRUE(read->scan.sensorInOdom.isApprox(scan.sensorInOdom, 1e-9));
}

TEST_P(UosRoom, FindsTheGridWithoutAHeader) {
    const TemporaryFolder folder;
    Scan scan = test::scanRoom({.sweep = GetParam(), .rows = 60, .columns = 120, .seed = 4}).scan;
    scan.points[119] = scan.points[120] = Eigen::Vector3f::Constant(std::nanf(""));
    Scan bare = scan;
    bare.rows = bare.columns = 0;
    bare.hasOdometry = false;
    ASSERT_TRUE(writeUosScan(folder / "scan003.3d", bare).ok());
    const auto read = readUosScan(folder / "scan003.3d");
    ASSERT_TRUE(read.ok()) << errorOf(read);
    expectSameScan(read->scan, scan);

    bare.points.pop_back();  // no longer complete
    ASSERT_TRUE(writeUosScan(folder / "scan003.3d", bare).ok());
    const auto incomplete = readUosScan(folder / "scan003.3d");
    ASSERT_TRUE(incomplete.ok()) << errorOf(incomplete);
    EXPECT_FALSE(incomplete->scan.organised());
}

INSTANTIATE_TEST_SUITE_P(Sweeps, UosRoom, ::testing::Values(Sweep::Tilting, Sweep::Yawing),
                         [](const auto& info) {
                             return info.param == Sweep::Tilting ? "Tilting" : "Yawing";
                         });

TEST(UosScan, LeavesCloudsInAnyOtherOrderUnorganised) {
    const TemporaryFolder folder;
    const PointCloud cloud = test::roomCloud(5'000, 1);
    Scan scan;
    scan.points = cloud.points;
    ASSERT_TRUE(writeUosScan(folder / "scan000.3d", scan).ok());
    const auto read = readUosScan(folder / "scan000.3d");
    ASSERT_TRUE(read.ok()) << errorOf(read);
    EXPECT_FALSE(read->scan.organised());
}

TEST(UosHall, HasThreeTiltingScansOf226RowsAnd360Columns) {
    LEITSTAND_HALL_OR_SKIP(hall);
    const Eigen::Vector3d positions[] = {
        {0, 0, 0}, {1.56917, 0.0310605, -0.0750803}, {3.37973, 0.0799848, -0.153529}};
    for (int i = 0; i < 3; ++i) {
        const auto read = readUosScan(hall / ("scan00" + std::to_string(i) + ".3d"));
        ASSERT_TRUE(read.ok()) << errorOf(read);
        EXPECT_THAT(read->warnings, IsEmpty());
        EXPECT_EQ(read->scan.points.size(), 81'360U);
        EXPECT_EQ(read->scan.rows, 226);
        EXPECT_EQ(read->scan.columns, 360);
        EXPECT_EQ(read->scan.sweep, Sweep::Tilting);
        EXPECT_TRUE(read->scan.hasOdometry);
        EXPECT_TRUE(read->scan.sensorInOdom.translation().isApprox(positions[i], 1e-6) || i == 0);
    }
}

TEST(UosHall, SurvivesWritingAndReading) {
    LEITSTAND_HALL_OR_SKIP(hall);
    const auto read = readUosScan(hall / "scan001.3d");
    ASSERT_TRUE(read.ok()) << errorOf(read);
    const TemporaryFolder folder;
    ASSERT_TRUE(writeUosScan(folder / "scan001.3d", read->scan).ok());
    const auto back = readUosScan(folder / "scan001.3d");
    ASSERT_TRUE(back.ok()) << errorOf(back);
    expectSameScan(back->scan, read->scan);
    EXPECT_TRUE(back->scan.sensorInOdom.isApprox(read->scan.sensorInOdom, 1e-12));
}

}  // namespace
}  // namespace leitstand
