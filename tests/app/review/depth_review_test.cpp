// Depth pictures in a mission's log: clouds wherever one begins to read.
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/log/decoded_log.h"
#include "app/services/log/event_decoder.h"
#include "app/services/log/log_entry.h"
#include "core/event/cloud_sample.h"
#include "core/event/event.h"
#include "core/event/picture_samples.h"
#include "core/event/stream_role.h"
#include "core/io/bag/bag_reader.h"
#include "core/io/bag/bag_writer.h"
#include "core/robot/robot_description.h"
#include "tests/support/samples.h"
#include "tests/support/temporary_folder.h"
#include "transport/convert/encode.h"

namespace leitstand::test {
namespace {

constexpr int Width = 32, Height = 24;

RobotDescription robotWithDepths() {
    RobotDescription robot;
    robot.name = "rover";
    robot.letter = "R";
    for (const auto& [role, topic, type] :
         {std::tuple(StreamRole::Points, "/depth/image_raw", "sensor_msgs/msg/Image"),
          std::tuple(StreamRole::CameraInfo, "/depth/camera_info", "sensor_msgs/msg/CameraInfo")}) {
        StreamDescription stream;
        stream.role = role;
        stream.sensor = "depth";
        stream.topic = topic;
        stream.type = type;
        robot.streams.push_back(stream);
    }
    return robot;
}

/// A wall at @p depth [mm].
PictureSample wall(std::uint16_t depth) {
    const std::vector<std::uint16_t> depths(std::size_t{Width} * Height, depth);
    std::vector<std::byte> bytes(depths.size() * 2);
    std::memcpy(bytes.data(), depths.data(), bytes.size());
    PictureSample sample;
    sample.header.frame = "optical";
    sample.encoding = "16UC1";
    sample.width = Width;
    sample.height = Height;
    sample.step = std::size_t{2} * Width;
    sample.content = sharedBytes(std::move(bytes));
    return sample;
}

CameraInfoSample calibration() {
    CameraInfoSample info;
    info.width = Width;
    info.height = Height;
    info.distortionModel = "plumb_bob";
    info.intrinsics = {16.0, 0.0, 15.5, 0.0, 16.0, 11.5, 0.0, 0.0, 1.0};
    return info;
}

/// A log of ten depth pictures, each 0.1 m farther off; the calibration comes after the second one, once.
class DepthReview : public testing::Test {
protected:
    DepthReview() {
        auto writer = BagWriter::open(m_mission);
        EXPECT_TRUE(writer) << writer.error().text;
        const auto add = [&](const std::string& topic, const std::string& type, const Sample& sample) {
            TopicInfo info;
            info.name = topic;
            info.type = type;
            (*writer)->addTopic(info);
            RawEvent event;
            event.sequence = ++m_sequence;
            event.received = Time(std::chrono::seconds(1'000 + m_sequence));
            event.topic = topic;
            event.type = type;
            event.cdr = encode(sample, type).value();
            (*writer)->write(event);
        };
        for (int i = 0; i < 10; ++i) {
            if (i == 2) add("/depth/camera_info", "sensor_msgs/msg/CameraInfo", calibration());
            add("/depth/image_raw", "sensor_msgs/msg/Image",
                wall(static_cast<std::uint16_t>(1'000 + 100 * i)));
        }
        EXPECT_TRUE((*writer)->close());
    }
    /// Depths of the clouds that @p query brings.
    [[nodiscard]] std::vector<float> depthsOf(const BagQuery& query) const {
        auto bag = BagReader::open(m_mission);
        EXPECT_TRUE(bag) << bag.error().text;
        EventDecoder decoder({robotWithDepths()});
        std::vector<float> depths;
        forEachEvent(**bag, decoder, query, [&](const Event& event) {
            EXPECT_FALSE(event.sample.is<PictureSample>());
            const auto* const cloud = event.sample.as<CloudSample>();
            if (cloud == nullptr) return;
            EXPECT_GT(cloud->points.size(), 600U);
            depths.push_back(cloud->points.front().z());
        });
        EXPECT_TRUE(decoder.errors().empty());
        return depths;
    }

    const TemporaryFolder m_folder;
    const std::filesystem::path m_mission = m_folder / "mission";
    std::uint64_t m_sequence = 0;
};

TEST_F(DepthReview, AllPicturesAreCloudsAlsoThoseBeforeTheCalibration) {
    BagQuery clouds;
    clouds.topics = {"/depth/image_raw"};
    const auto depths = depthsOf(clouds);
    ASSERT_EQ(depths.size(), 10U);
    EXPECT_FLOAT_EQ(depths.front(), 1.0F);
    EXPECT_FLOAT_EQ(depths.back(), 1.9F);
}

TEST_F(DepthReview, WhoBeginsLaterKnowsTheCalibration) {
    BagQuery clouds;
    clouds.topics = {"/depth/image_raw"};
    clouds.fromSequence = 8;
    EXPECT_EQ(depthsOf(clouds).size(), 4U);
    auto bag = BagReader::open(m_mission);
    ASSERT_TRUE(bag);
    EventDecoder decoder({robotWithDepths()});
    const auto raw = (*bag)->event(7);
    ASSERT_TRUE(raw);
    const auto event = decodedAlone(**bag, decoder, *raw);
    ASSERT_TRUE(event);
    EXPECT_TRUE(event->sample.is<CloudSample>());
    EXPECT_EQ(event->role, StreamRole::Points);
}

TEST_F(DepthReview, ACameraThatNeverSaysItsCalibrationIsReported) {
    EventDecoder decoder({robotWithDepths()});
    RawEvent event;
    event.topic = "/depth/image_raw";
    event.type = "sensor_msgs/msg/Image";
    event.cdr = encode(wall(2'000), event.type).value();
    for (int i = 0; i < 20; ++i)
        decoder.decode(event, [](const Event&) { ADD_FAILURE() << "not a cloud yet"; });
    EXPECT_TRUE(decoder.errors().empty()) << "it may come";
    for (int i = 0; i < 100; ++i)
        decoder.decode(event, [](const Event&) { ADD_FAILURE() << "not a cloud yet"; });
    ASSERT_TRUE(decoder.errors().contains(event.topic));
    EXPECT_NE(decoder.errors().at(event.topic).last.find("camera_info"), std::string::npos);
}

}  // namespace
}  // namespace leitstand::test
