#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/handin/report_scene.h"

namespace leitstand::test {
namespace {

using State = OccupancyGrid::State;

TEST(VoxelEvidence, ARayFreesWhatItPassesAndTheEchoOccupies) {
    const std::vector<ReportScan> scans = {scanOf({{2.02F, 0.02F, 0.02F}})};
    const VoxelEvidence evidence = VoxelEvidence::of(scans);
    const auto at = [&](double x, double y) {
        const Eigen::Vector3i cube =
            (Eigen::Vector3d(x, y, 0.01) / evidence.cell()).array().floor().cast<int>() -
            evidence.first().array();
        return evidence.at(cube.x(), cube.y(), cube.z());
    };
    EXPECT_EQ(at(2.02, 0.02), evidence.settings().hit);
    EXPECT_EQ(at(1.02, 0.01), evidence.settings().miss);
    EXPECT_EQ(at(1.02, 0.30), 0);
    EXPECT_EQ(at(2.30, 0.02), 0) << "behind the echo nobody knows";
}

TEST(VoxelEvidence, AnEchoOutweighsOtherRaysOfItsScan) {
    // Two points behind each other: the far one's ray passes the near one's cube.
    const std::vector<ReportScan> scans = {scanOf({{1.02F, 0.02F, 0.02F}, {2.02F, 0.02F, 0.02F}})};
    const VoxelEvidence evidence = VoxelEvidence::of(scans);
    const Eigen::Vector3i cube = Eigen::Vector3i(20, 0, 0) - evidence.first();
    EXPECT_EQ(evidence.at(cube.x(), cube.y(), cube.z()), evidence.settings().hit);
}

TEST(VoxelEvidence, HostileScansMakeNoHugeMap) {
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    std::vector<ReportScan> scans = {scanOf({{1, 0, 0}, {nan, 0, 0}, {inf, 1, 1}, {1e30F, 0, 0}})};
    scans.push_back(scans.front());
    scans.push_back(scans.front());
    scans.back().scanInMap.translation() = Eigen::Vector3d(1e9, -1e9, 1e9);
    const VoxelEvidence evidence = VoxelEvidence::of(scans);
    EXPECT_LT(evidence.size().prod(), 200'000);
    EXPECT_TRUE(VoxelEvidence::of(std::vector<ReportScan>{scanOf({})}).empty());
    EXPECT_TRUE(VoxelEvidence::of({}).empty());
    EvidenceSettings few;
    few.mostCells = 1000;
    EXPECT_LE(VoxelEvidence::of(scans, few).size().prod(), 1000);
}

TEST(OccupancyGrid, ARoomHasItsWallsAndIsFreeWithin) {
    const auto scans = roomScans();
    const OccupancyGrid grid = roomGrid(scans);
    EXPECT_EQ(grid.at(0.0, 0.5).state, State::Free);
    EXPECT_GT(grid.at(0.0, 0.5).confidence, 0.4F);
    int walls = 0;
    for (double x = -1.5; x < 1.5; x += 0.05) {
        walls +=
            grid.at(x, -3.0).state == State::Occupied || grid.at(x, -2.97).state == State::Occupied ? 1 : 0;
    }
    EXPECT_GT(walls, 55) << "of 60 places along the right wall";
    EXPECT_EQ(grid.at(0.0, 3.4).state, State::Unexplored);
    EXPECT_EQ(grid.at(100.0, 3.4).state, State::Unexplored);
    EXPECT_NEAR(exploredArea(grid), 48.0, 8.0);
}

TEST(FloorHeights, ARampCountsAsFloorATableDoesNot) {
    std::vector<Eigen::Vector3f> points;
    std::vector<Label> labels;
    const auto add = [&](float x, float y, float z) {
        points.emplace_back(x, y, z);
        labels.push_back(Label::Floor);
    };
    for (float x = -1.0F; x < 6.0F; x += 0.04F) {
        for (float y = -1.0F; y < 1.0F; y += 0.04F) {
            const bool table = x > 0.5F && x < 1.0F && y > 0.4F;
            add(x, y, table ? 0.75F : std::max(0.0F, 0.2F * (x - 2.0F)));
        }
    }
    const std::vector<ReportScan> scans = {scanOf(points, labels)};
    const std::vector<Eigen::Vector3d> ground = {Eigen::Vector3d::Zero()};
    const FloorHeights floor = FloorHeights::of(scans, ground);
    EXPECT_NEAR(floor.at(0.0, 0.0), 0.0, 0.02);
    EXPECT_NEAR(floor.at(5.0, 0.0), 0.6, 0.03);
    EXPECT_NEAR(floor.at(0.75, 0.7), 0.0, 0.03) << "below the table";
    EXPECT_FALSE(floor.seen(0.75, 0.7));
    EXPECT_TRUE(floor.seen(0.75, 0.0));
    EXPECT_NEAR(floor.at(50.0, 0.0), 0.8, 0.05) << "as at the nearest place";
    EXPECT_EQ(FloorHeights::of({}, {}).at(1.0, 2.0), 0.0);
}

TEST(OccupancyGrid, HeightsCountFromTheLocalFloor) {
    // A floor that rises to 1 m, on it a wall of 0.5 m.
    std::vector<Eigen::Vector3f> points;
    std::vector<Label> labels;
    for (float x = 0.5F; x < 7.0F; x += 0.03F) {
        for (float y = -1.0F; y < 1.0F; y += 0.03F) {
            points.emplace_back(x, y, std::clamp(0.25F * (x - 1.0F), 0.0F, 1.0F));
            labels.push_back(Label::Floor);
        }
    }
    for (float y = -1.0F; y < 1.0F; y += 0.03F) {
        // Half of it ends 0.5 m above its floor.
        for (float z = 1.0F; z < (y < 0.5F ? 1.5F : 2.3F); z += 0.03F) {
            points.emplace_back(6.51F, y, z);
            labels.push_back(Label::Wall);
        }
    }
    ReportScan scan = scanOf(points, labels);
    const std::vector<ReportScan> scans = {scan};
    const std::vector<Eigen::Vector3d> ground = {{0.6, 0.0, 0.0}};
    const FloorHeights floor = FloorHeights::of(scans, ground);
    const VoxelEvidence evidence = VoxelEvidence::of(scans);
    const OccupancyGrid low = gridOf(evidence, floor, reportBands()[0]),
                        high = gridOf(evidence, floor, reportBands()[1]);
    EXPECT_EQ(low.at(6.51, 0.0).state, State::Occupied);
    EXPECT_NE(high.at(6.51, 0.0).state, State::Occupied) << "the wall ends 0.5 m above its floor";
    EXPECT_EQ(low.at(6.51, 0.75).state, State::Occupied);
    EXPECT_EQ(high.at(6.51, 0.75).state, State::Occupied);
    EXPECT_EQ(low.at(5.5, 0.0).state, State::Free) << "a raised floor is no obstacle";
}

TEST(Occupancy, PlaneLasersShowTheirOwnHeightAlsoWhereAnAreaLeavesThemFewPoints) {
    std::vector<Eigen::Vector3f> turn;
    for (int i = 0; i < 60; ++i) turn.emplace_back(2.02F, 0.05F * static_cast<float>(i - 30) + 0.02F, 0.0F);
    ReportScan whole = scanOf(turn, std::vector<Label>(turn.size(), Label::Wall)), few = whole, none = whole;
    whole.scanInMap = few.scanInMap = none.scanInMap = poseFrom({0.0, 0.0, 0.19}, 0.0, 0.0, 0.0);
    few.scan = scanOf({{1.0F, 0.0F, 0.0F}}, {Label::Wall}).scan;
    none.scan = std::make_shared<const Scan>();
    const std::vector<ReportScan> scans = {whole, few, none};
    const FloorHeights floor = FloorHeights::of(scans, std::vector<Eigen::Vector3d>{{0.0, 0.0, 0.0}});
    const std::vector<HeightBand> bands = bandsOf(scans, floor);
    ASSERT_EQ(bands.size(), 1U);
    EXPECT_LT(bands[0].low, 0.19);
    EXPECT_GT(bands[0].high, 0.19);
    EXPECT_EQ(gridOf(VoxelEvidence::of(scans), floor, bands[0]).at(2.02, 0.02).state, State::Occupied);
    ReportScan spatial = whole;
    spatial.scan = scanOf({{1.0F, 0.0F, 0.1F}}, {Label::Wall}).scan;
    EXPECT_EQ(bandsOf(std::vector<ReportScan>{whole, spatial}, floor).size(), 2U);
}

}  // namespace
}  // namespace leitstand::test
