#include "core/mapping/comparison/map_comparison.h"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand {
namespace {

using testing::SizeIs;

RegistrationSettings oneThread() {
    RegistrationSettings settings;
    settings.threads = 1;
    return settings;
}

/// A room of 6 m x 4 m x 2.5 m as seen from @p sensorInRoom, every few centimetres.
ScanPtr roomFrom(const Pose& sensorInRoom) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    auto scan = std::make_shared<Scan>();
    for (int i = 0; i < 6'000; ++i) {
        const double x = 6.0 * unit(random), y = 4.0 * unit(random), z = 2.5 * unit(random);
        Eigen::Vector3d point(x, y, z);
        const int side = i % 6;
        point[side / 2] = side % 2 == 0 ? 0.0 : Eigen::Vector3d(6.0, 4.0, 2.5)[side / 2];
        scan->points.push_back((sensorInRoom.inverse() * point).cast<float>());
        scan->labels.push_back(side == 4 ? Label::Floor : side == 5 ? Label::Ceiling : Label::Wall);
    }
    scan->sensorInOdom = sensorInRoom;
    scan->hasOdometry = true;
    return scan;
}

/// Three scans of Kurt3D, of which the second one was recorded @p wrong beside its place.
std::vector<ComparedScan> drive(double wrong) {
    std::vector<ComparedScan> scans;
    for (int i = 0; i < 3; ++i) {
        const Pose place = poseFrom({2.0 + 0.3 * i, 2.0, 1.0}, 0.0, 0.0, 0.1 * i);
        ComparedScan one;
        one.id = static_cast<std::uint64_t>(i + 1);
        one.robot = "kurt3d";
        one.scan = roomFrom(place);
        one.recorded = poseFrom({0.0, i == 1 ? wrong : 0.0, 0.0}, 0, 0, 0) * place;
        scans.push_back(std::move(one));
    }
    return scans;
}

TEST(MapComparison, FindsThatAScanWasRecordedWrong) {
    const auto made = registeredAgain(drive(0.05), oneThread());
    ASSERT_TRUE(made);
    ASSERT_THAT(made->scans, SizeIs(3));
    EXPECT_NEAR(made->mostMoved, 0.05, 0.01);
    EXPECT_NEAR(made->meanMoved, 0.05 / 3.0, 0.005);
    EXPECT_LT(made->mostTurned, degrees(0.5));
    EXPECT_FALSE(made->scans[0].fitRecorded) << "there is none before it";
    ASSERT_TRUE(made->scans[1].fitRecorded && made->scans[1].fitAgain);
    EXPECT_LT(made->again.rms, made->recorded.rms);
    EXPECT_GE(made->again.overlap, made->recorded.overlap);
    EXPECT_NEAR(made->again.path, 0.6, 0.02);
    EXPECT_EQ(made->again.uncertain, 0);
    EXPECT_GE(made->again.seconds.value_or(-1.0), 0.0);
}

TEST(MapComparison, OdometryThatBeginsAnewBetweenTwoScansTearsNothing) {
    auto scans = drive(0.0);
    for (std::size_t i = 1; i < scans.size(); ++i) {  // the robot was restarted after its first scan
        auto restarted = std::make_shared<Scan>(*scans[i].scan);
        restarted->sensorInOdom = poseFrom({-2.3, -2.0, -1.0}, 0, 0, 2.0) * restarted->sensorInOdom;
        scans[i].scan = restarted;
    }
    const auto made = registeredAgain(scans, oneThread());
    ASSERT_TRUE(made);
    EXPECT_LT(made->mostMoved, 0.02);
    EXPECT_EQ(made->again.uncertain, 0);
}

TEST(MapComparison, ScansOfAnotherRobotAreRegisteredForThemselves) {
    auto scans = drive(0.0);
    scans[1].robot = "crawler";
    scans[1].recorded = poseFrom({9.0, 9.0, 1.0}, 0, 0, 1.0);
    const auto made = registeredAgain(scans, oneThread());
    ASSERT_TRUE(made);
    EXPECT_TRUE(made->scans[1].again.isApprox(scans[1].recorded)) << "its first stands where it was";
    EXPECT_NEAR(made->recorded.path, 0.6, 1e-9);
}

TEST(MapComparison, CancelledThereIsNothing) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(registeredAgain(drive(0.0), {}, {{}, stop.get_token()}));
}

TEST(MapComparison, BothMapsAreShownOneWithoutLabels) {
    const auto made = registeredAgain(drive(0.05), oneThread());
    ASSERT_TRUE(made);
    EXPECT_THAT(mapOf(*made, ComparedMap::Recorded)->scans, SizeIs(3));
    EXPECT_TRUE(mapOf(*made, ComparedMap::Again)->scans[1].poseInMap.isApprox(made->scans[1].again));
    const MapPtr both = mapOf(*made, ComparedMap::Both);
    ASSERT_THAT(both->scans, SizeIs(6));
    EXPECT_THAT(both->scans[0].scan->labels, testing::Each(Label::Unlabelled));
    EXPECT_THAT(both->scans[0].scan->points, SizeIs(5'000)) << "no ceiling";
    EXPECT_EQ(both->scans[3].scan, made->scans[0].scan);
}

}  // namespace
}  // namespace leitstand
