#include "app/services/station/cameras/picture_feed.h"

#include <future>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/picture_samples.h"
#include "core/event/stream_role.h"
#include "core/perception/pictures/video/video_chains.h"
#include "tests/core/perception/video/filmed.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

RobotDescription robotWithCameras(bool measured = true) {
    RobotDescription robot;
    robot.name = "kurt3d";
    StreamDescription heat;
    heat.role = StreamRole::Thermal;
    heat.sensor = "ir";
    heat.thermal = {0.01, 0.0, measured};
    robot.streams.push_back(heat);
    return robot;
}

Event picture(StreamRole role, const std::string& sensor, std::uint16_t value, int width = 2,
              int height = 1) {
    auto bytes = std::make_shared<std::vector<std::byte>>();
    for (int i = 0; i < 2; ++i) {
        bytes->push_back(static_cast<std::byte>(value & 0xFFU));
        bytes->push_back(static_cast<std::byte>(value >> 8U));
    }
    PictureSample sample;
    sample.encoding = "16UC1";
    sample.width = width;
    sample.height = height;
    sample.step = std::size_t{2} * static_cast<std::size_t>(width);
    sample.content = {bytes, *bytes};
    Event event;
    event.robot = "kurt3d";
    event.topic = "/kurt3d/" + sensor;
    event.role = role;
    event.sensor = sensor;
    event.sample = sample;
    return event;
}

class Shown {
public:
    PictureFeed::Listener listener() {
        return {[this](const ShownPicturePtr& one) {
                    if (m_gate.valid()) m_gate.wait();
                    const std::scoped_lock lock(m_mutex);
                    m_pictures.push_back(one);
                },
                [this](const std::string& text) {
                    const std::scoped_lock lock(m_mutex);
                    m_problems.push_back(text);
                }};
    }
    void holdUntil(std::shared_future<void> gate) { m_gate = std::move(gate); }
    [[nodiscard]] std::vector<ShownPicturePtr> pictures() const {
        const std::scoped_lock lock(m_mutex);
        return m_pictures;
    }
    [[nodiscard]] std::vector<std::string> problems() const {
        const std::scoped_lock lock(m_mutex);
        return m_problems;
    }

private:
    mutable std::mutex m_mutex;
    std::shared_future<void> m_gate;
    std::vector<ShownPicturePtr> m_pictures;
    std::vector<std::string> m_problems;
};

Event filmedEvent(const PictureSample& sample) {
    Event event = picture(StreamRole::Picture, "left", 0);
    event.sample = sample;
    return event;
}

TEST(PictureFeed, AVideoIsShownFromItsFirstKeyPictureOn) {
    Shown shown;
    PictureFeed feed({robotWithCameras()}, shown.listener());
    auto film = filmed(25, 10);
    film.erase(film.begin(), film.begin() + 4);
    VideoChains chains;
    for (PictureSample& sample : film) {
        chains.link("/kurt3d/left", sample);
        feed.onEvent(filmedEvent(sample));
    }
    ASSERT_TRUE(waitUntil([&] {
        const auto pictures = shown.pictures();
        return !pictures.empty() && pictures.back()->stamp == film.back().header.stamp;
    }));
    for (const ShownPicturePtr& one : shown.pictures()) {
        const auto number =
            static_cast<int>(one->stamp.time_since_epoch() / std::chrono::milliseconds(100)) - 1;
        EXPECT_GE(number, 10);
        EXPECT_LT(difference(std::get<Picture>(one->content), movingScene(number)), 6.0) << number;
    }
    EXPECT_THAT(shown.problems(), testing::IsEmpty()) << "waiting for a key picture is no fault";
}

TEST(PictureFeed, AVideoWithoutKeyPicturesIsReported) {
    Shown shown;
    PictureFeed feed({robotWithCameras()}, shown.listener());
    auto film = filmed(160, 1000, VideoCodec::H264, 32, 32);
    film.erase(film.begin());
    VideoChains chains;
    for (PictureSample& sample : film) chains.link("/kurt3d/left", sample);
    feed.onEvent(filmedEvent(film.back()));
    ASSERT_TRUE(waitUntil([&] { return !shown.problems().empty(); }));
    EXPECT_THAT(shown.problems().front(), testing::HasSubstr("gop_size"));
    EXPECT_TRUE(shown.pictures().empty());
}

TEST(PictureFeed, MeasuringCamerasShowTemperatures) {
    Shown shown;
    PictureFeed feed({robotWithCameras()}, shown.listener());
    feed.onEvent(picture(StreamRole::Thermal, "ir", 30'615));
    ASSERT_TRUE(waitUntil([&] { return !shown.pictures().empty(); }));
    const auto* heat = std::get_if<ThermalPicture>(&shown.pictures()[0]->content);
    ASSERT_NE(heat, nullptr);
    EXPECT_NEAR(heat->celsius[0], 33.0F, 0.01F);
}

TEST(PictureFeed, ColourMappedInfraredIsAPictureWithoutTemperatures) {
    Shown shown;
    PictureFeed feed({robotWithCameras(false)}, shown.listener());
    feed.onEvent(picture(StreamRole::Thermal, "ir", 30'615));
    ASSERT_TRUE(waitUntil([&] { return !shown.pictures().empty(); }));
    EXPECT_TRUE(std::holds_alternative<Picture>(shown.pictures()[0]->content));
}

TEST(PictureFeed, WhoeverIsSlowSeesTheNewestOfEachCamera) {
    Shown shown;
    std::promise<void> gate;
    shown.holdUntil(gate.get_future().share());
    PictureFeed feed({robotWithCameras()}, shown.listener());
    feed.onEvent(picture(StreamRole::Picture, "left", 1));
    // The first is at work or waits; of the others one a camera is left in the end.
    for (std::uint16_t value = 2; value < 50; ++value) {
        feed.onEvent(picture(StreamRole::Picture, "left", value));
        feed.onEvent(picture(StreamRole::Picture, "right", value));
    }
    gate.set_value();
    const auto last = [&](const std::string& sensor) {
        std::uint64_t fingerprint = 0;
        for (const auto& one : shown.pictures()) {
            if (one->sensor == sensor) fingerprint = one->fingerprint;
        }
        return fingerprint;
    };
    Shown alone;
    PictureFeed other({robotWithCameras()}, alone.listener());
    other.onEvent(picture(StreamRole::Picture, "left", 49));
    ASSERT_TRUE(waitUntil([&] { return !alone.pictures().empty(); }));
    const auto newest = alone.pictures()[0]->fingerprint;
    EXPECT_TRUE(waitUntil([&] { return last("left") == newest && last("right") == newest; }));
    EXPECT_LE(shown.pictures().size(), 5u);
}

/// A grey omnidirectional picture, @p value all over.
Event omniPicture(std::uint8_t value, int side = 320) {
    auto bytes = std::make_shared<std::vector<std::byte>>(static_cast<std::size_t>(side * side),
                                                          static_cast<std::byte>(value));
    PictureSample sample;
    sample.encoding = "mono8";
    sample.width = sample.height = side;
    sample.step = static_cast<std::size_t>(side);
    sample.content = {bytes, *bytes};
    Event event;
    event.sequence = value;
    event.robot = "kurt3d";
    event.topic = "/kurt3d/omni";
    event.role = StreamRole::Picture;
    event.sensor = "omni";
    event.sample = sample;
    return event;
}

Event mirrorInfo() {
    CameraInfoSample info;
    info.width = info.height = 320;
    info.distortionModel = "mei";
    info.distortion = {-0.01, 0.0, 0.0, 0.0, 0.95};
    info.intrinsics = {110, 0, 160, 0, 110, 160, 0, 0, 1};
    Event event;
    event.robot = "kurt3d";
    event.role = StreamRole::CameraInfo;
    event.sensor = "omni";
    event.sample = info;
    return event;
}

TEST(PictureFeed, ALookIsAppliedAtOnceAndLeavesTheSampleAsItCame) {
    RobotDescription robot = robotWithCameras();
    robot.sensors["omni"].sensorInBase = poseFrom({0, 0, 0.3}, degrees(180), 0, degrees(-90));
    Shown shown;
    PictureFeed feed({robot}, shown.listener());
    feed.onEvent(mirrorInfo());
    feed.onEvent(omniPicture(20));
    ASSERT_TRUE(waitUntil([&] { return shown.pictures().size() == 1; }));
    EXPECT_FALSE(shown.pictures()[0]->panorama);
    EXPECT_NE(shown.pictures()[0]->camera, nullptr);
    feed.setLook("kurt3d", "omni", {ContrastHelp::Strong, true});
    ASSERT_TRUE(waitUntil([&] { return shown.pictures().size() == 2; })) << "although no picture came";
    const ShownPicture& made = *shown.pictures()[1];
    ASSERT_TRUE(made.panorama);
    EXPECT_EQ(made.contrast, ContrastHelp::Strong);
    EXPECT_EQ(made.sequence, shown.pictures()[0]->sequence);
    EXPECT_EQ(std::get<Picture>(made.content).width, made.panorama->width);
    EXPECT_EQ(made.width, 320);
    EXPECT_EQ(made.sample.width, 320);
    EXPECT_EQ(made.sample.content.bytes[0], std::byte{20});
    feed.setLook("kurt3d", "omni", {ContrastHelp::Strong, true});
    feed.onEvent(omniPicture(21));
    ASSERT_TRUE(waitUntil([&] { return shown.pictures().back()->sequence == 21; }));
    EXPECT_EQ(shown.pictures().size(), 3U) << "the same look again is none";
    feed.onEvent(omniPicture(22, 160));  // a thin link: reduced
    ASSERT_TRUE(waitUntil([&] { return shown.pictures().back()->sequence == 22; }));
    ASSERT_TRUE(shown.pictures().back()->panorama);
    EXPECT_LT(shown.pictures().back()->panorama->width, made.panorama->width);
}

TEST(PictureFeed, InfraredGetsBodiesButNoContrast) {
    Shown shown;
    PictureFeed feed({robotWithCameras(false)}, shown.listener());
    feed.setLook("kurt3d", "ir", {ContrastHelp::Strong, true});
    feed.onEvent(picture(StreamRole::Thermal, "ir", 30'615));
    ASSERT_TRUE(waitUntil([&] { return !shown.pictures().empty(); }));
    EXPECT_EQ(shown.pictures()[0]->contrast, ContrastHelp::Off);
}

TEST(PictureFeed, ABrokenPictureIsToldOnceAndCostsNoOther) {
    Shown shown;
    PictureFeed feed({robotWithCameras()}, shown.listener());
    for (int i = 1; i <= 3; ++i) {
        feed.onEvent(picture(StreamRole::Picture, "left", 7, 4000, 4000));  // its bytes are two pixels
        feed.onEvent(picture(StreamRole::Picture, "right", 7));
        ASSERT_TRUE(waitUntil([&] { return shown.pictures().size() >= static_cast<std::size_t>(i); }));
    }
    ASSERT_TRUE(waitUntil([&] { return !shown.problems().empty(); }));
    EXPECT_EQ(shown.problems().size(), 1u);
    EXPECT_THAT(shown.problems()[0], testing::HasSubstr("/kurt3d/left"));
}

}  // namespace
}  // namespace leitstand::test
