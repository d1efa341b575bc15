#include "core/cloud/labels.h"

#include <array>
#include <cstdio>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/rooms.h"

namespace leitstand {
namespace {

using test::RoomScan;
using test::RoomSettings;
using test::scanRoom;

constexpr float EdgeMargin = 0.10F;

/// How often which true label got which label, at least EdgeMargin away from edges.
struct Confusion {
    std::array<std::array<int, LabelCount>, LabelCount> counts{};  ///< [true][found]

    void add(const RoomScan& room, const std::vector<Label>& labels) {
        for (std::size_t i = 0; i < labels.size(); ++i) {
            if (room.edgeDistances[i] <= EdgeMargin) continue;
            ++counts[static_cast<std::size_t>(room.trueLabels[i])][static_cast<std::size_t>(labels[i])];
        }
    }
    [[nodiscard]] double right() const {
        int right = 0, all = 0;
        for (std::size_t truth = 0; truth < LabelCount; ++truth) {
            right += counts[truth][truth];
            for (const int count : counts[truth]) all += count;
        }
        return static_cast<double>(right) / all;
    }
    void print(const std::string& title) const {
        constexpr std::array<const char*, LabelCount> Names = {"unlabelled", "floor", "wall", "ceiling"};
        std::printf("%s: %.2f %% right\n%22s%10s%10s%10s\n", title.c_str(), 100.0 * right(), Names[0],
                    Names[1], Names[2], Names[3]);
        for (std::size_t truth = 1; truth < LabelCount; ++truth) {
            std::printf("  %-10s", Names[truth]);
            for (const int count : counts[truth]) std::printf("%10d", count);
            std::printf("\n");
        }
    }
};

/// Levels, and tilts by 10 degrees about one and about both axes.
std::vector<Pose> attitudes() {
    const double tilt = degrees(10), half = degrees(7.07);
    return {poseFrom({0.2, 0.1, 1.0}, 0, 0, degrees(25)),
            poseFrom({0, 0, 1.0}, tilt, 0, 0),
            poseFrom({-0.3, 0.2, 1.0}, -tilt, 0, degrees(140)),
            poseFrom({0, 0, 1.0}, 0, tilt, degrees(-60)),
            poseFrom({0.1, 0, 0.5}, 0, -tilt, degrees(80)),
            poseFrom({0, -0.2, 1.0}, half, -half, degrees(10))};
}

class LabelsOfRooms : public testing::TestWithParam<Sweep> {};

TEST_P(LabelsOfRooms, AreRightOnATiltedRobotWithNoise) {
    const std::string sweep = GetParam() == Sweep::Tilting ? "tilting" : "yawing";
    int number = 0;
    for (const Pose& pose : attitudes()) {
        RoomSettings settings;
        settings.sweep = GetParam();
        settings.sensorInRoom = pose;
        settings.seed = static_cast<unsigned>(++number);
        const RoomScan room = scanRoom(settings);
        Confusion confusion;
        confusion.add(room, labelScan(room.scan));
        confusion.print(sweep + ", attitude " + std::to_string(number));
        EXPECT_GE(confusion.right(), 0.98);
    }
}

TEST_P(LabelsOfRooms, FollowGravityWhereItIsKnown) {
    RoomSettings settings;
    settings.sweep = GetParam();
    settings.sensorInRoom = poseFrom({0, 0, 1.0}, degrees(35), degrees(-20), 0);
    const RoomScan room = scanRoom(settings);
    Confusion confusion;
    confusion.add(room, labelScan(room.scan, {.up = settings.sensorInRoom.linear().transpose().col(2)}));
    confusion.print("35 and 20 degrees, gravity known");
    EXPECT_GE(confusion.right(), 0.98);
}

TEST_P(LabelsOfRooms, AreRightWithoutTheGridToo) {
    RoomSettings settings;
    settings.sweep = GetParam();
    settings.rows = 113;
    settings.columns = 180;
    settings.rangeNoise = 0.005;
    RoomScan room = scanRoom(settings);
    room.scan.rows = room.scan.columns = 0;
    Confusion confusion;
    confusion.add(room, labelScan(room.scan));
    confusion.print("without the grid");
    EXPECT_GE(confusion.right(), 0.95);
}

INSTANTIATE_TEST_SUITE_P(Sweeps, LabelsOfRooms, testing::Values(Sweep::Tilting, Sweep::Yawing),
                         [](const auto& sweep) {
                             return sweep.param == Sweep::Tilting ? "Tilting" : "Yawing";
                         });

TEST(Labels, ACorridorIsLabelledToItsEnd) {
    RoomSettings settings;
    settings.length = 20.0;
    settings.sensorInRoom = poseFrom({-8, 0, 0.6}, 0, 0, 0);
    const RoomScan corridor = test::scanCorridor(settings);
    Confusion confusion;
    confusion.add(corridor, labelScan(corridor.scan));
    confusion.print("corridor");
    EXPECT_GE(confusion.right(), 0.98);
}

TEST(Labels, AreLeftOpenWhereNothingDecides) {
    RoomSettings settings;
    RoomScan room = scanRoom(settings);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto at = [&](int row, int column) -> Eigen::Vector3f& {
        return room.scan.points[static_cast<std::size_t>(row * settings.columns + column)];
    };
    at(100, 100).setConstant(nan);   // no echo
    at(50, 180) *= 0.5F;             // a point on its own in mid-air
    at(150, 60).setConstant(1e30F);  // nonsense of a broken driver
    at(151, 200).setZero();
    const std::vector<Label> labels = labelScan(room.scan);
    ASSERT_EQ(labels.size(), room.scan.points.size());
    for (const auto& [row, column] : {std::pair{100, 100}, {50, 180}, {150, 60}, {151, 200}}) {
        EXPECT_EQ(labels[static_cast<std::size_t>(row * settings.columns + column)], Label::Unlabelled)
            << row << ", " << column;
    }
    Confusion confusion;
    confusion.add(room, labels);
    EXPECT_GE(confusion.right(), 0.98);  // their neighbours do not suffer
}

TEST(Labels, SmallAndSilentScansHaveNone) {
    Scan scan;
    EXPECT_TRUE(labelScan(scan).empty());
    scan.points.assign(1, Eigen::Vector3f(1, 0, 0));
    EXPECT_EQ(labelScan(scan), std::vector<Label>(1, Label::Unlabelled));
    scan.rows = scan.columns = 1;
    EXPECT_EQ(labelScan(scan), std::vector<Label>(1, Label::Unlabelled));
    scan.rows = 20;
    scan.columns = 30;
    scan.points.assign(600, Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
    EXPECT_EQ(labelScan(scan), std::vector<Label>(600, Label::Unlabelled));
}

TEST(Labels, OfNormalsFollowTheSettings) {
    const std::vector<Eigen::Vector3f> normals = {
        {0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, 0, 0}, {0.5F, 0, 0.866F}};
    EXPECT_EQ(labelNormals(normals),
              (std::vector{Label::Floor, Label::Ceiling, Label::Wall, Label::Unlabelled, Label::Floor}));
    EXPECT_EQ(labelNormals(normals, {.steepest = degrees(20)}).back(), Label::Wall);
    EXPECT_EQ(labelNormals(normals, {.up = Eigen::Vector3d::UnitX()})[2], Label::Floor);
}

}  // namespace
}  // namespace leitstand
