// What robots draw.
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/map_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "messages/geometry_msgs.h"
#include "messages/std_msgs.h"
#include "messages/vision_msgs.h"
#include "messages/visualization_msgs.h"
#include "transport/cdr/cdr_writer.h"
#include "transport/convert/decode.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;
using testing::SizeIs;
using WireMarker = wire::visualization_msgs::Marker;

template <class Message>
Result<Sample> decoded(const Message& message, StreamRole role = StreamRole::Markers) {
    CdrWriter out;
    encode(out, message);
    StreamDescription stream;
    stream.role = role;
    stream.topic = "/kurt3d/markers";
    return decode(RawEvent{1, Time(), stream.topic, std::string(Message::RosName),
                           std::make_shared<const std::vector<std::byte>>(std::move(out).finish())},
                  stream);
}

template <class Message>
MarkersSample markersOf(const Message& message) {
    const auto sample = decoded(message);
    EXPECT_TRUE(sample) << sample.error().text;
    return sample ? sample->template get<MarkersSample>() : MarkersSample();
}

WireMarker wireMarker(std::int32_t type, std::int32_t id = 1) {
    WireMarker marker;
    marker.header.frame_id = "map";
    marker.ns = "way";
    marker.id = id;
    marker.type = type;
    marker.pose.orientation.w = 1.0;
    marker.scale = {0.5, 0.5, 0.5};
    marker.color = {1.0F, 0.5F, 0.0F, 1.0F};
    return marker;
}

TEST(Markers, OfAllTypesAreShapes) {
    const std::pair<std::int32_t, MarkerShape> types[] = {
        {WireMarker::ARROW_, MarkerShape::Arrow},
        {WireMarker::CUBE_, MarkerShape::Box},
        {WireMarker::SPHERE_, MarkerShape::Ellipsoid},
        {WireMarker::CYLINDER_, MarkerShape::Cylinder},
        {WireMarker::LINE_STRIP_, MarkerShape::LineStrip},
        {WireMarker::LINE_LIST_, MarkerShape::LineList},
        {WireMarker::CUBE_LIST_, MarkerShape::Box},
        {WireMarker::SPHERE_LIST_, MarkerShape::Ellipsoid},
        {WireMarker::POINTS_, MarkerShape::Points},
        {WireMarker::TEXT_VIEW_FACING_, MarkerShape::Text},
        {WireMarker::MESH_RESOURCE_, MarkerShape::Box},
        {WireMarker::TRIANGLE_LIST_, MarkerShape::Triangles},
    };
    for (const auto& [type, shape] : types) {
        const MarkersSample sample = markersOf(wireMarker(type));
        ASSERT_THAT(sample.markers, SizeIs(1));
        EXPECT_EQ(sample.markers[0].shape, shape) << type;
        EXPECT_FALSE(sample.replacesAll);
    }
    EXPECT_EQ(markersOf(wireMarker(12)).markers.at(0).shape, MarkerShape::LineStrip) << "of Jazzy";
    EXPECT_THAT(decoded(wireMarker(13)).error().text, HasSubstr("markers.type: expected 0 to 12, found 13"));
}

TEST(Markers, AreRemovedOneByOneOrAll) {
    wire::visualization_msgs::MarkerArray message;
    message.markers = {wireMarker(WireMarker::CUBE_, 1), wireMarker(0, 2), wireMarker(WireMarker::CUBE_, 3)};
    message.markers[1].action = WireMarker::DELETEALL_;
    message.markers.push_back(wireMarker(99, 4));
    message.markers.back().action = WireMarker::DELETE_;
    const MarkersSample sample = markersOf(message);
    EXPECT_TRUE(sample.replacesAll);
    ASSERT_THAT(sample.markers, SizeIs(2)) << "what came before all were removed is gone, too";
    EXPECT_EQ(sample.markers[0].id, 3);
    EXPECT_EQ(sample.markers[1].id, 4);
    EXPECT_TRUE(sample.markers[1].removed);
}

TEST(Markers, WithoutARotationAndWithOddColoursAreTaken) {
    WireMarker marker = wireMarker(WireMarker::CUBE_);
    marker.pose.orientation = {};
    marker.color = {2.0F, std::nanf(""), -1.0F, 1.0F};
    const MarkersSample sample = markersOf(marker);
    EXPECT_TRUE(sample.markers.at(0).markerInFrame.linear().isIdentity());
    EXPECT_EQ(sample.markers.at(0).colour, (MarkerColour{1.0F, 0.0F, 0.0F, 1.0F}));
}

TEST(Markers, ThatMakeNoSenseAreLeftOutAmongOthers) {
    wire::visualization_msgs::MarkerArray message;
    message.markers = {wireMarker(0, 1), wireMarker(99, 2), wireMarker(WireMarker::CUBE_, 3)};
    message.markers[0].action = WireMarker::DELETEALL_;
    const MarkersSample sample = markersOf(message);
    EXPECT_TRUE(sample.replacesAll);
    ASSERT_THAT(sample.markers, SizeIs(1));
    EXPECT_EQ(sample.markers[0].id, 3);
}

TEST(Markers, ThatAreNowhereOrTooManyAreRefused) {
    WireMarker marker = wireMarker(WireMarker::CUBE_);
    marker.pose.position.x = std::nan("");
    EXPECT_FALSE(decoded(marker));
    marker.pose.position.x = 1e9;
    EXPECT_THAT(decoded(marker).error().text, HasSubstr("markers.pose: expected at most 1000000 m"));
    marker = wireMarker(WireMarker::LINE_STRIP_);
    marker.points.resize(MarkersSample::MostPoints + 1);
    EXPECT_FALSE(decoded(marker));
    wire::visualization_msgs::MarkerArray message;
    message.markers.assign(MarkersSample::MostMarkers + 1, wireMarker(WireMarker::CUBE_));
    EXPECT_THAT(decoded(message).error().text, HasSubstr("markers: expected at most 5000, found 5001"));
}

TEST(Markers, OfAnOutlineAreClosed) {
    wire::geometry_msgs::PolygonStamped message;
    message.header.frame_id = "odom";
    message.polygon.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    const MarkersSample sample = markersOf(message);
    EXPECT_TRUE(sample.replacesAll);
    ASSERT_THAT(sample.markers, SizeIs(1));
    ASSERT_THAT(sample.markers[0].points, SizeIs(4));
    EXPECT_EQ(sample.markers[0].points.back(), sample.markers[0].points.front());
    EXPECT_EQ(sample.markers[0].header.frame, "odom");
    EXPECT_GT(sample.markers[0].lifetime.count(), 0) << "who sent it may end";
    EXPECT_THAT(markersOf(wire::geometry_msgs::PolygonStamped{}).markers, SizeIs(0));
}

TEST(Markers, OfAPoseShowItsDoubt) {
    wire::geometry_msgs::PoseWithCovarianceStamped message;
    message.header.frame_id = "map";
    message.pose.pose.position.x = 3.0;
    message.pose.covariance[0] = 0.01;
    message.pose.covariance[7] = 0.25;
    const MarkersSample sample = markersOf(message);
    ASSERT_THAT(sample.markers, SizeIs(2));
    EXPECT_EQ(sample.markers[0].shape, MarkerShape::Arrow);
    const Marker& doubt = sample.markers[1];
    EXPECT_EQ(doubt.shape, MarkerShape::Ellipsoid);
    EXPECT_NEAR(doubt.markerInFrame.translation().x(), 3.0, 1e-12);
    // 0.1 m and 0.5 m: four of them across.
    EXPECT_NEAR(doubt.size.head<2>().minCoeff(), 0.4, 1e-9);
    EXPECT_NEAR(doubt.size.head<2>().maxCoeff(), 2.0, 1e-9);
    const Eigen::Vector3d along = doubt.markerInFrame.linear() * Eigen::Vector3d::UnitX();
    EXPECT_NEAR(std::abs(along.x()), 1.0, 1e-9) << "the smaller one lies along x";
    message.pose.covariance.fill(std::nan(""));
    EXPECT_THAT(markersOf(message).markers, SizeIs(1)) << "nobody knows its doubt";
}

TEST(Markers, OfDetectionsAreBoxesWithTheirBestClass) {
    wire::vision_msgs::Detection3DArray message;
    message.header.frame_id = "camera";
    auto& detection = message.detections.emplace_back();
    detection.bbox.center.position.z = 2.0;
    detection.bbox.size = {0.5, 0.5, 1.8};
    detection.results.resize(2);
    detection.results[0].hypothesis = {"door", 0.2};
    detection.results[1].hypothesis = {"person", 0.875};
    const MarkersSample sample = markersOf(message);
    EXPECT_TRUE(sample.replacesAll);
    ASSERT_THAT(sample.markers, SizeIs(2));
    EXPECT_EQ(sample.markers[0].shape, MarkerShape::Box);
    EXPECT_EQ(sample.markers[0].header.frame, "camera") << "the detection has no frame of its own";
    EXPECT_EQ(sample.markers[1].text, "person 0.88");
}

wire::vision_msgs::Detection2DArray boxes(std::size_t count) {
    wire::vision_msgs::Detection2DArray message;
    message.header.frame_id = "camera";
    for (std::size_t i = 0; i < count; ++i) {
        auto& detection = message.detections.emplace_back();
        detection.bbox.center.position = {320.0, 240.0};
        detection.bbox.size_x = 64.0;
        detection.bbox.size_y = 128.0;
        detection.results.resize(2);
        detection.results[0].hypothesis = {"door", 0.2};
        detection.results[1].hypothesis = {std::string(1'000, 'p'), 0.875};
    }
    return message;
}

Result<Sample> decodedBoxes(const wire::vision_msgs::Detection2DArray& message) {
    return decoded(message, StreamRole::Detections);
}

TEST(Detections2D, AreBoxesWithTheirLikeliestClass) {
    const auto sample = decodedBoxes(boxes(2));
    ASSERT_TRUE(sample) << sample.error().text;
    const auto& seen = sample->get<DetectionsSample>();
    EXPECT_EQ(seen.header.frame, "camera");
    ASSERT_THAT(seen.detections, SizeIs(2));
    EXPECT_EQ(seen.detections[0].centre, Eigen::Vector2d(320, 240));
    EXPECT_EQ(seen.detections[0].size, Eigen::Vector2d(64, 128));
    EXPECT_EQ(seen.detections[0].label, std::string(200, 'p')) << "names are cut";
    EXPECT_EQ(seen.detections[0].score, 0.875);
}

TEST(Detections2D, ThatMakeNoSenseAreRefused) {
    EXPECT_TRUE(decodedBoxes(boxes(0)));
    EXPECT_TRUE(decodedBoxes(boxes(DetectionsSample::Most)));
    EXPECT_THAT(decodedBoxes(boxes(DetectionsSample::Most + 1))->get<DetectionsSample>().detections,
                SizeIs(DetectionsSample::Most))
        << "the first ones";
    auto message = boxes(1);
    message.detections[0].bbox.center.position.x = std::nan("");
    EXPECT_THAT(decodedBoxes(message).error().text, HasSubstr("bbox.center"));
    message = boxes(3);
    message.detections[1].bbox.center.position.x = std::nan("");
    EXPECT_THAT(decodedBoxes(message)->get<DetectionsSample>().detections, SizeIs(2)) << "the others";
    message = boxes(1);
    message.detections[0].bbox.size_x = -1.0;
    EXPECT_THAT(decodedBoxes(message).error().text, HasSubstr("bbox: expected 0 to"));
    message = boxes(1);
    message.detections[0].bbox.size_y = 1e300;
    EXPECT_FALSE(decodedBoxes(message));
    message = boxes(1);
    message.detections[0].results[1].hypothesis.score = std::nan("");
    message.detections[0].results[0].hypothesis.score = std::nan("");
    EXPECT_TRUE(std::isnan(decodedBoxes(message)->get<DetectionsSample>().detections[0].score));
}

TEST(RobotModels, AreTakenAsTextUpToTheirLimit) {
    wire::std_msgs::String message;
    message.data = "<robot/>";
    EXPECT_EQ(decoded(message, StreamRole::Model)->get<RobotModelSample>().urdf, "<robot/>");
    message.data.assign(RobotModelSample::MostBytes, 'x');
    EXPECT_TRUE(decoded(message, StreamRole::Model));
    message.data += 'x';
    EXPECT_THAT(decoded(message, StreamRole::Model).error().text, HasSubstr("expected a model of at most"));
}

}  // namespace
}  // namespace leitstand::test
