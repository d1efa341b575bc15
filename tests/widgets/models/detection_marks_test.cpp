// What detectors see, over the pictures of cameras.
#include "widgets/models/camera/detection_marks.h"

#include <gtest/gtest.h>

#include "core/event/picture_samples.h"
#include "core/event/stream_role.h"

namespace leitstand::test {
namespace {

constexpr Time Now{std::chrono::seconds(1'000)};

StreamDescription stream(StreamRole role, const std::string& sensor, const std::string& topic) {
    StreamDescription made;
    made.role = role;
    made.sensor = sensor;
    made.topic = topic;
    return made;
}

/// A robot with two cameras, and a detector on /seen.
RobotDescription rover(const std::string& detectorsCamera) {
    RobotDescription robot;
    robot.streams = {stream(StreamRole::Picture, "front", "/front"),
                     stream(StreamRole::Picture, "rear", "/rear"),
                     stream(StreamRole::Detections, detectorsCamera, "/seen")};
    return robot;
}

RobotState seeing(const std::string& frame, Time stamp = Now) {
    RobotState state;
    const Detection person{{200, 100}, {40, 80}, 0.0, "person", 0.87};
    state.detections["/seen"] =
        latestPtr(Latest<DetectionsSample>{1, Now, DetectionsSample{{stamp, frame}, {person}}});
    return state;
}

PictureUnderDetections picture(const std::string& sensor, const std::string& frame) {
    return {sensor, frame, Now, Now, 400, 200};
}

TEST(DetectionMarks, LieInThePictureWithWhatTheyAre) {
    const auto marks = detectionMarks(rover("front"), seeing(""), picture("front", "f"));
    ASSERT_EQ(marks.size(), 1U);
    EXPECT_EQ(marks[0].text, QStringLiteral("person 87\u202f%"));
    EXPECT_NEAR(marks[0].corners[0].x(), 0.45, 1e-9);
    EXPECT_NEAR(marks[0].corners[0].y(), 0.3, 1e-9);
    EXPECT_NEAR(marks[0].corners[2].x(), 0.55, 1e-9);
    EXPECT_NEAR(marks[0].corners[2].y(), 0.7, 1e-9);
}

TEST(DetectionMarks, BelongToTheCameraOfTheFileElseToTheOneWithTheirFrame) {
    EXPECT_TRUE(detectionMarks(rover("front"), seeing("r"), picture("rear", "r")).empty());
    EXPECT_EQ(detectionMarks(rover(""), seeing("r"), picture("rear", "r")).size(), 1U);
    EXPECT_TRUE(detectionMarks(rover(""), seeing("r"), picture("front", "f")).empty());
    EXPECT_TRUE(detectionMarks(rover(""), seeing(""), picture("front", "f")).empty()) << "which of both?";
    RobotDescription one = rover("");
    one.streams.erase(one.streams.begin());
    EXPECT_EQ(detectionMarks(one, seeing(""), picture("rear", "r")).size(), 1U);
}

TEST(DetectionMarks, OfAnotherMomentAreLeftOut) {
    EXPECT_EQ(detectionMarks(rover("front"), seeing("", Now - std::chrono::milliseconds(900)),
                             picture("front", "f"))
                  .size(),
              1U);
    EXPECT_TRUE(
        detectionMarks(rover("front"), seeing("", Now - std::chrono::seconds(2)), picture("front", "f"))
            .empty());
    PictureUnderDetections later = picture("front", "f");
    later.stamp = {};
    EXPECT_EQ(detectionMarks(rover("front"), seeing(""), later).size(), 1U) << "by when they were received";
    later.received = Now + std::chrono::seconds(2);
    EXPECT_TRUE(detectionMarks(rover("front"), seeing(""), later).empty());
}

TEST(DetectionMarks, AreTurnedAsTheDetectorSays) {
    RobotState state = seeing("");
    auto turned = *state.detections["/seen"];
    turned.sample.detections[0].turned = 3.14159265358979 / 2;
    state.detections["/seen"] = latestPtr(turned);
    const auto marks = detectionMarks(rover("front"), state, picture("front", "f"));
    const QPointF along = marks.at(0).corners[1] - marks.at(0).corners[0];
    EXPECT_NEAR(along.x(), 0.0, 1e-9);
    EXPECT_NEAR(along.y(), 0.2, 1e-9) << "40 of 200 pixels, downwards";
}

}  // namespace
}  // namespace leitstand::test
