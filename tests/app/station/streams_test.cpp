#include "app/services/station/station_streams.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/picture_samples.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "tests/app/station/station_scene.h"
#include "tests/support/dds/robot_listener.h"
#include "tests/support/places.h"
#include "tests/transport/dds/test_node.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

/// A station on the real simulated Kurt3D.
class StationStreamsTest : public StationScene {
protected:
    [[nodiscard]] StreamStatus stream(const std::string& leaf) const {
        const LinkStatus link = station->robot("kurt3d").link;
        const StreamStatus* found = link.stream("/kurt3d/" + leaf);
        return found == nullptr ? StreamStatus{} : *found;
    }
    void start() {
        process.emplace(program("leitstand-robot"), kurtArguments());
        if (!station) station = stationFor({kurt3d()});
        ASSERT_TRUE(waitUntil([&] { return stream(Left).rate > 8.0 && stream(Points).rate > 8.0; }, 60s))
            << words() << process->out();
    }
    static constexpr const char* Left = "left/image/compressed";
    static constexpr const char* Right = "right/image/compressed";
    static constexpr const char* Points = "points";

    std::optional<ChildProcess> process;
    std::unique_ptr<Station> station;
};

TEST_F(StationStreamsTest, ARateIsFollowedByTheRobotAndAlsoAfterItsRestart) {
    start();
    StationStreams& streams = station->streams();
    ASSERT_TRUE(streams.request("kurt3d", "/kurt3d/left/image/compressed", {.rate = 3.0}).ok());
    ASSERT_TRUE(waitUntil([&] { return stream(Left).rate < 4.0; }, 60s)) << stream(Left).rate;
    EXPECT_GT(stream(Left).rate, 1.0);
    EXPECT_GT(stream(Right).rate, 6.0) << "the other camera is left alone";

    process->signal(SIGKILL);
    (void)process->wait();
    ASSERT_TRUE(waitUntil([&] { return station->robot("kurt3d").link.state == LinkState::Lost; }, 60s));
    process.emplace(program("leitstand-robot"), kurtArguments());
    ASSERT_TRUE(waitUntil([&] { return stream(Right).rate > 6.0; }, 60s)) << words();
    ASSERT_TRUE(waitUntil([&] { return stream(Left).rate > 1.0 && stream(Left).rate < 4.0; }, 60s))
        << "a robot that comes back is told again";

    ASSERT_TRUE(streams.request("kurt3d", "/kurt3d/left/image/compressed", {}).ok());
    EXPECT_TRUE(waitUntil([&] { return stream(Left).rate > 8.0; }, 60s)) << "as the robot likes";
}

TEST_F(StationStreamsTest, PicturesBecomeCoarserAndSmallerAsTheyAreWished) {
    start();
    const std::string topic = std::string("/kurt3d/") + Left;
    const RobotDescription robot = kurt3d();
    const auto described = std::find_if(robot.streams.begin(), robot.streams.end(),
                                        [&](const StreamDescription& one) { return one.topic == topic; });
    ASSERT_NE(described, robot.streams.end());
    const auto node = nodeIn(m_domain);
    const RobotListener camera(*node, std::vector{*described});
    struct Size {
        std::size_t bytes = 0;
        int width = 0;
    };
    const auto newest = [&] {
        const auto pictures = camera.all<PictureSample>(topic);
        if (pictures.empty()) return Size();
        const auto decoded = decodePicture(pictures.back());
        EXPECT_TRUE(decoded.ok());
        return Size{pictures.back().content.bytes.size(), decoded ? decoded->width : 0};
    };
    ASSERT_TRUE(camera.receives(topic));
    const Size before = newest();
    StationStreams& streams = station->streams();
    ASSERT_TRUE(streams.request("kurt3d", topic, {.quality = 15}).ok());
    EXPECT_TRUE(waitUntil([&] { return newest().bytes < before.bytes * 6 / 10; }, 60s))
        << newest().bytes << " of " << before.bytes << " bytes";
    EXPECT_EQ(newest().width, before.width);
    ASSERT_TRUE(streams.request("kurt3d", topic, {.maxWidth = before.width / 2}).ok());
    EXPECT_TRUE(waitUntil([&] { return newest().width == before.width / 2; }, 60s)) << newest().width;
    ASSERT_TRUE(streams.request("kurt3d", topic, {}).ok());
    EXPECT_TRUE(waitUntil(
        [&] { return newest().width == before.width && newest().bytes > before.bytes * 7 / 10; }, 60s))
        << "as the robot likes";
}

TEST_F(StationStreamsTest, AThinLinkKeepsScansAndOneCameraAndGivesAllBack) {
    start();
    StationStreams& streams = station->streams();
    const double before = station->robot("kurt3d").link.megabitsPerSecond;
    streams.setThin({.budget = 0.6 * before});
    streams.thin({}, true);
    EXPECT_TRUE(streams.isThin("kurt3d"));
    ASSERT_TRUE(
        waitUntil([&] { return station->robot("kurt3d").link.megabitsPerSecond < 0.75 * before; }, 60s))
        << before << " Mbit/s before, " << station->robot("kurt3d").link.megabitsPerSecond;
    EXPECT_GT(stream(Points).rate, 8.0) << "scans stay";
    EXPECT_GT(stream("odom").rate, 10.0);
    EXPECT_GT(stream(Left).rate, 0.5) << "one camera survives";
    EXPECT_TRUE(waitUntil([&] { return stream(Right).rate < 2.0; }, 60s));
    EXPECT_FALSE(streams.effective("kurt3d", "/kurt3d/right/image/compressed").isPlain());
    EXPECT_TRUE(waitUntil([&] { return station->robot("kurt3d").link.state == LinkState::Connected; }, 60s))
        << "what is off is no fault";

    streams.thin({}, false);
    EXPECT_TRUE(waitUntil([&] { return stream(Left).rate > 8.0 && stream(Right).rate > 6.0; }, 60s));
    EXPECT_TRUE(streams.effective("kurt3d", "/kurt3d/right/image/compressed").isPlain());
}

TEST_F(StationStreamsTest, WishesForWhatIsNotThereAreErrors) {
    const auto quiet = stationFor({kurt3d()});
    StationStreams& streams = quiet->streams();
    EXPECT_FALSE(streams.request("nobody", "/nobody/points", {}).ok());
    const auto none = streams.request("kurt3d", "/kurt3d/cmd_vel", {});
    ASSERT_FALSE(none.ok());
    EXPECT_THAT(none.error().text, testing::HasSubstr("/kurt3d/cmd_vel"));
    EXPECT_TRUE(streams.takesRequests("kurt3d"));
}

}  // namespace
}  // namespace leitstand::test
