#include "app/session/station/picture_feed.h"

#include <future>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
    sample.step = 2 * width;
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

TEST(PictureFeed, MeasuringCamerasShowTemperatures) {
    Shown shown;
    PictureFeed feed({robotWithCameras()}, shown.listener());
    feed.take(picture(StreamRole::Thermal, "ir", 30'615));
    ASSERT_TRUE(waitUntil([&] { return !shown.pictures().empty(); }));
    const auto* heat = std::get_if<ThermalPicture>(&shown.pictures()[0]->content);
    ASSERT_NE(heat, nullptr);
    EXPECT_NEAR(heat->celsius[0], 33.0F, 0.01F);
}

TEST(PictureFeed, ColourMappedInfraredIsAPictureWithoutTemperatures) {
    Shown shown;
    PictureFeed feed({robotWithCameras(false)}, shown.listener());
    feed.take(picture(StreamRole::Thermal, "ir", 30'615));
    ASSERT_TRUE(waitUntil([&] { return !shown.pictures().empty(); }));
    EXPECT_TRUE(std::holds_alternative<Picture>(shown.pictures()[0]->content));
}

TEST(PictureFeed, WhoeverIsSlowSeesTheNewestOfEachCamera) {
    Shown shown;
    std::promise<void> gate;
    shown.holdUntil(gate.get_future().share());
    PictureFeed feed({robotWithCameras()}, shown.listener());
    feed.take(picture(StreamRole::Picture, "left", 1));
    // The first is at work or waits; of the others one a camera is left in the end.
    for (std::uint16_t value = 2; value < 50; ++value) {
        feed.take(picture(StreamRole::Picture, "left", value));
        feed.take(picture(StreamRole::Picture, "right", value));
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
    other.take(picture(StreamRole::Picture, "left", 49));
    ASSERT_TRUE(waitUntil([&] { return !alone.pictures().empty(); }));
    const auto newest = alone.pictures()[0]->fingerprint;
    EXPECT_TRUE(waitUntil([&] { return last("left") == newest && last("right") == newest; }));
    EXPECT_LE(shown.pictures().size(), 5u);
}

TEST(PictureFeed, ABrokenPictureIsToldOnceAndCostsNoOther) {
    Shown shown;
    PictureFeed feed({robotWithCameras()}, shown.listener());
    for (int i = 1; i <= 3; ++i) {
        feed.take(picture(StreamRole::Picture, "left", 7, 4000, 4000));  // its bytes are two pixels
        feed.take(picture(StreamRole::Picture, "right", 7));
        ASSERT_TRUE(waitUntil([&] { return shown.pictures().size() >= static_cast<std::size_t>(i); }));
    }
    ASSERT_TRUE(waitUntil([&] { return !shown.problems().empty(); }));
    EXPECT_EQ(shown.problems().size(), 1u);
    EXPECT_THAT(shown.problems()[0], testing::HasSubstr("/kurt3d/left"));
}

}  // namespace
}  // namespace leitstand::test
