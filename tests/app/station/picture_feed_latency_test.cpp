// How long a picture of a video takes from the packet to the eye.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <mutex>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/station/cameras/picture_feed.h"
#include "core/event/picture_samples.h"
#include "core/event/stream_role.h"
#include "core/perception/pictures/video/video_chains.h"
#include "tests/core/perception/video/filmed.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

using Clock = std::chrono::steady_clock;

TEST(PictureFeedLatency, AVideoOf720pAt30HzIsShownWithin40Milliseconds) {
    constexpr auto Period = std::chrono::milliseconds(33);
    auto film = filmed(90, 30, VideoCodec::H264, 1280, 720);
    VideoChains chains;
    for (PictureSample& sample : film) chains.link("/rover/front", sample);
    std::mutex mutex;
    std::vector<Clock::time_point> came(film.size()), shown(film.size());
    PictureFeed feed({}, {[&](const ShownPicturePtr& one) {
                              const std::scoped_lock lock(mutex);
                              shown[one->sequence - 1] = Clock::now();
                          },
                          {}});
    const auto begin = Clock::now();
    for (std::size_t i = 0; i < film.size(); ++i) {
        std::this_thread::sleep_until(begin + i * Period);
        Event event;
        event.sequence = i + 1;
        event.robot = "rover";
        event.topic = "/rover/front";
        event.role = StreamRole::Picture;
        event.sensor = "front";
        event.sample = film[i];
        came[i] = Clock::now();
        feed.onEvent(event);
    }
    ASSERT_TRUE(waitUntil([&] {
        const std::scoped_lock lock(mutex);
        return shown.back() != Clock::time_point();
    }));
    const std::scoped_lock lock(mutex);
    std::vector<double> took;  // [ms]
    for (std::size_t i = 0; i < film.size(); ++i)
        if (shown[i] != Clock::time_point())
            took.push_back(std::chrono::duration<double, std::milli>(shown[i] - came[i]).count());
    std::sort(took.begin(), took.end());
    std::printf("720p at 30 Hz: %zu of %zu pictures shown, median %.1f, 95 %% %.1f, at most %.1f ms\n",
                took.size(), film.size(), took[took.size() / 2], took[took.size() * 95 / 100], took.back());
    EXPECT_GE(took.size(), film.size() * 95 / 100) << "the feed keeps up";
    EXPECT_LE(took[took.size() * 95 / 100], 40.0);
}

}  // namespace
}  // namespace leitstand::test
