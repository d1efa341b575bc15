// What a robot draws, as it lies in the map.
#include "widgets/models/map/robots/robot_drawings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/motion_samples.h"
#include "core/mapping/live/robot_in_map.h"
#include "core/mission/markers/marker_board.h"
#include "core/robot/robot_description.h"

namespace leitstand {
namespace {

using testing::SizeIs;

constexpr Time Now{std::chrono::seconds(1'000)};

class RobotDrawings : public testing::Test {
protected:
    RobotDrawings() {
        OdometrySample odometry;
        odometry.header.frame = "odom";
        odometry.childFrame = "base_link";
        m_reported.odometry = latestPtr(Latest<OdometrySample>{1, {}, odometry});
        m_robot.name = "k";
        m_robot.tfPrefix = TfPrefix::None;
        m_robot.sensors["camera"].frame = "camera_link";
        m_robot.sensors["camera"].sensorInBase = poseFrom({0.2, 0, 0.5}, 0, 0, 0);
        m_place.placed = true;
        m_place.baseInMap = poseFrom({2, 0, 0}, 0, 0, 0);
        m_place.odomInMap = Pose::Identity();
    }
    void draws(std::vector<Marker> markers) {
        MarkerBoard board;
        board.take({true, std::move(markers)}, Now, poseFrom({2, 0, 0}, 0, 0, 0));
        m_reported.markers["/markers"] = latestPtr(Latest<MarkerBoard>{++m_sequence, Now, board});
    }
    static Marker marker(MarkerShape shape, const char* frame = "base_link") {
        Marker made;
        made.header.frame = frame;
        made.shape = shape;
        made.id = static_cast<int>(shape);
        return made;
    }
    std::shared_ptr<const Drawings> now(Time at = Now) {
        return m_drawer.at(m_robot, m_reported, m_place, at);
    }

    RobotDescription m_robot;
    RobotState m_reported;
    RobotInMap m_place;
    RobotDrawer m_drawer;
    std::uint64_t m_sequence = 0;
};

TEST_F(RobotDrawings, AreLinesDotsAndTexts) {
    Marker strip = marker(MarkerShape::LineStrip);
    strip.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    Marker dots = marker(MarkerShape::Points);
    dots.points = {{0, 0, 0}};
    Marker text = marker(MarkerShape::Text);
    text.text = "exit\n\u202e";
    draws({marker(MarkerShape::Box), strip, dots, text});
    const auto drawings = now();
    ASSERT_TRUE(drawings);
    EXPECT_THAT(drawings->lines, SizeIs(6 + 1)) << "a box has twelve edges, in six lines";
    EXPECT_NEAR(drawings->lines.back().places.front().x(), 2.0, 1e-9) << "where the robot is";
    EXPECT_THAT(drawings->dots, SizeIs(1));
    ASSERT_THAT(drawings->texts, SizeIs(1));
    EXPECT_FALSE(drawings->texts[0].text.contains(QChar(0x202e))) << "nobody turns our words";
}

TEST_F(RobotDrawings, StayWhereTheyWereSeenUnlessTheyAreLocked) {
    draws({marker(MarkerShape::Arrow, "camera_link"), marker(MarkerShape::Box, "nowhere")});
    auto drawings = now();
    ASSERT_TRUE(drawings);
    ASSERT_THAT(drawings->lines, SizeIs(2)) << "the arrow and its head; nobody knows where the box is";
    EXPECT_NEAR(drawings->lines[0].places[0].x(), 2.2, 1e-9);
    EXPECT_NEAR(drawings->lines[0].places[0].z(), 0.5, 1e-9);
    EXPECT_EQ(now(), drawings) << "nothing moved";
    m_place.baseInMap = poseFrom({3, 0, 0}, 0, 0, 0);
    EXPECT_EQ(now(), drawings) << "the robot drives on, what it saw stays";
    m_place.odomInMap = poseFrom({0, 1, 0}, 0, 0, 0);
    drawings = now();
    EXPECT_NEAR(drawings->lines[0].places[0].y(), 1.0, 1e-9) << "the map moved";
    m_place.odomInMap = Pose::Identity();
    Marker locked = marker(MarkerShape::Arrow, "camera_link");
    locked.frameLocked = true;
    draws({locked});
    EXPECT_NEAR(now()->lines[0].places[0].x(), 3.2, 1e-9);
    m_place.baseInMap = poseFrom({4, 0, 0}, 0, 0, 0);
    EXPECT_NEAR(now()->lines[0].places[0].x(), 4.2, 1e-9);
    m_place.placed = false;
    EXPECT_FALSE(now());
}

TEST_F(RobotDrawings, NeedAPlaceOfTheirSensor) {
    m_robot.sensors["camera"].sensorInBase = Pose::Identity();
    draws({marker(MarkerShape::Arrow, "camera_link")});
    EXPECT_FALSE(now()) << "only tf tells where it is";
    draws({marker(MarkerShape::Arrow, "base_footprint")});
    EXPECT_FALSE(now());
    m_robot.baseFrame = "base_footprint";
    draws({marker(MarkerShape::Arrow, "base_footprint")});
    EXPECT_TRUE(now()) << "the base of the robot's file";
}

TEST_F(RobotDrawings, EndWithTheirLifetime) {
    Marker brief = marker(MarkerShape::Box);
    brief.lifetime = std::chrono::seconds(2);
    draws({brief});
    EXPECT_TRUE(now(Now + std::chrono::seconds(1)));
    EXPECT_FALSE(now(Now + std::chrono::seconds(3)));
    EXPECT_TRUE(now(Now + std::chrono::seconds(1))) << "a review goes back";
}

TEST_F(RobotDrawings, OfEveryShapeAreSeenAndBounded) {
    for (int shape = 0; shape <= static_cast<int>(MarkerShape::Triangles); ++shape) {
        Marker one = marker(static_cast<MarkerShape>(shape));
        one.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        one.text = "a";
        draws({one});
        EXPECT_TRUE(now()) << shape;
    }
    Marker many = marker(MarkerShape::Box);
    many.points.resize(20'000, Eigen::Vector3d::Zero());
    draws({many});
    std::size_t places = 0;
    for (const Drawings::Line& line : now()->lines) places += line.places.size();
    EXPECT_EQ(places, Drawings::MostPlaces);
    Marker invisible = marker(MarkerShape::Box);
    invisible.colour.a = 0.0F;
    draws({invisible});
    EXPECT_FALSE(now());
}

}  // namespace
}  // namespace leitstand
