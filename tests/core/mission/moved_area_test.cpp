#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/map_samples.h"
#include "core/event/station_samples.h"
#include "core/mission/state/checkpoint/checkpoint.h"
#include "core/mission/state/fold.h"
#include "tests/core/mission/event_stream.h"

namespace leitstand {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A mission with two scans 10 m apart, and an area with corners near each.
class MovedArea : public testing::Test {
protected:
    MovedArea() {
        for (const std::uint64_t id : {1, 2}) {
            KeyScanSample scan = test::keyScan(id, 0.0);
            scan.matched = id - 1;
            scan.scanInMap = Pose(Eigen::Translation3d(10.0 * static_cast<double>(id - 1), 0, 0.5));
            publish(std::move(scan));
        }
    }
    std::uint64_t publish(Sample sample) {
        fold.add(test::event(++sequence, std::move(sample)));
        return sequence;
    }
    std::uint64_t draw() {
        return publish(MapCropSample{.stamp = {}, .station = "us", .polygon = {{0, -1}, {10, -1}, {10, 1}}});
    }
    /// A closed loop has the second scan there.
    std::uint64_t close(const Pose& secondInMap) {
        ScanPosesSample poses{{}, "us", ScanPosesSample::Cause::LoopClosure, {}};
        poses.poses.push_back({.scan = 2, .scanInMap = secondInMap});
        return publish(poses);
    }
    std::uint64_t undo(std::uint64_t event) {
        UndoSample undo;
        undo.event = event;
        return publish(undo);
    }
    [[nodiscard]] std::vector<Eigen::Vector2d> area() const { return areaInMap(fold.state()); }

    Fold fold;
    std::uint64_t sequence = 0;
};

const Pose Moved = poseFrom({10.5, 2.0, 0.5}, 0, 0, degrees(90));

auto isAbout(double x, double y) {
    return testing::Truly(
        [x, y](const Eigen::Vector2d& corner) { return (corner - Eigen::Vector2d(x, y)).norm() < 1e-9; });
}

TEST_F(MovedArea, CornersGoWithTheScanThatIsNearest) {
    EXPECT_THAT(area(), IsEmpty());
    draw();
    EXPECT_THAT(area(), ElementsAre(Eigen::Vector2d(0, -1), Eigen::Vector2d(10, -1), Eigen::Vector2d(10, 1)));
    close(Moved);
    EXPECT_THAT(area(), ElementsAre(isAbout(0, -1), isAbout(11.5, 2.0), isAbout(9.5, 2.0)));
}

TEST_F(MovedArea, WhatWasDrawnInTheMovedMapGoesBackWithIt) {
    const std::uint64_t closed = close(Moved);
    draw();
    EXPECT_THAT(area(), ElementsAre(isAbout(0, -1), isAbout(10, -1), isAbout(10, 1)));
    undo(closed);
    EXPECT_THAT(area(), ElementsAre(isAbout(0, -1), isAbout(7.0, 0.5), isAbout(9.0, 0.5)))
        << "the place it was drawn at, in the map as it is without the loop";
}

TEST_F(MovedArea, TheOneOfBeforeComesBackToWhereItsPlaceIsNow) {
    draw();
    const std::uint64_t open =
        publish(MapCropSample{.stamp = {}, .station = "us", .polygon = {}, .ceiling = 2.0});
    close(Moved);
    EXPECT_THAT(area(), IsEmpty());
    undo(open);
    EXPECT_THAT(area(), ElementsAre(isAbout(0, -1), isAbout(11.5, 2.0), isAbout(9.5, 2.0)));
}

TEST_F(MovedArea, ACheckpointHasTheSame) {
    const std::uint64_t closed = close(Moved);
    draw();
    undo(closed);
    const auto back = deserialised(serialised(fold.state()));
    ASSERT_TRUE(back.ok()) << back.error().text;
    EXPECT_EQ(areaInMap(*back), area());
}

TEST_F(MovedArea, NothingHangsOnAPartThatLiesAside) {
    KeyScanSample aside = test::keyScan(3, 0.0);
    aside.matched = 0;
    aside.scanInMap = Pose(Eigen::Translation3d(5, -50, 0));
    publish(aside);
    publish(MapCropSample{.stamp = {}, .station = "us", .polygon = {{0, -1}, {10, -1}, {5, -40}}});
    ScanPosesSample poses{{}, "us", ScanPosesSample::Cause::LoopClosure, {}};
    poses.poses.push_back({.scan = 3, .scanInMap = Pose(Eigen::Translation3d(5, 3, 0))});
    publish(poses);
    EXPECT_THAT(area(), ElementsAre(isAbout(0, -1), isAbout(10, -1), isAbout(5, -40)))
        << "it has met the map";
}

TEST_F(MovedArea, BeforeThereIsAnyScanItStaysWhereItWasDrawn) {
    Fold empty;
    empty.add(
        test::event(1, MapCropSample{.stamp = {}, .station = "us", .polygon = {{0, 0}, {1, 0}, {1, 1}}}));
    KeyScanSample scan = test::keyScan(1, 0.0);
    empty.add(test::event(2, scan));
    scan.scanInMap = Moved;
    ScanPosesSample poses{{}, "us", ScanPosesSample::Cause::LoopClosure, {{.scan = 1, .scanInMap = Moved}}};
    empty.add(test::event(3, poses));
    EXPECT_THAT(areaInMap(empty.state()), ElementsAre(isAbout(0, 0), isAbout(1, 0), isAbout(1, 1)));
}

}  // namespace
}  // namespace leitstand
