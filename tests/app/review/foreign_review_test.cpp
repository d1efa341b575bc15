#include <algorithm>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <future>
#include <mutex>
#include <stop_token>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/comparison/map_comparing.h"
#include "app/services/offline/mission_scans.h"
#include "app/services/review/playing/review_player.h"
#include "app/services/review/review_pen.h"
#include "core/event/cloud_sample.h"
#include "core/event/motion_samples.h"
#include "core/event/picture_samples.h"
#include "core/mission/state/checkpoint/checkpoint.h"
#include "core/mission/state/scan_state.h"
#include "tests/app/report/foreign_bag.h"
#include "tests/io/bag/sample_bags.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

using testing::Contains;
using testing::HasSubstr;

constexpr std::size_t Scans = ForeignBag::Steps / 2 + 1;

/// A drive of somebody else's robot, recorded by somebody else's recorder.
class ForeignReview : public testing::Test {
protected:
    void SetUp() override { ForeignBag(m_bag).drive(); }
    const TemporaryFolder m_folder;
    const std::filesystem::path m_bag = m_folder / "rover";
};

TEST_F(ForeignReview, MapPicturesAndWayAreThoseOfTheMoment) {
    ASSERT_TRUE(isReviewable(m_bag));
    const std::string before = fingerprint(m_bag);
    const auto log = ReviewLog::open(m_bag).value();
    ASSERT_TRUE(log->lacksMap());
    log->makeMap({});
    EXPECT_FALSE(log->lacksMap());
    const ReviewIndexPtr index = indexOf(*log);
    EXPECT_EQ(index->keyScans.size(), Scans);
    ReviewScene scene(*log, *index);
    // To and fro: a moment is the same whichever was looked at before.
    for (const int step : {ForeignBag::Steps, 3, 9, 0, 6}) {
        const Time now = ForeignBag::at(step + 0.9);
        const ReviewMomentPtr moment = scene.at(now);
        EXPECT_EQ(moment->map->scans.size(), static_cast<std::size_t>(step / 2 + 1)) << step;
        EXPECT_EQ(moment->scans->scans.size(), moment->map->scans.size()) << step;
        ASSERT_EQ(moment->pictures.size(), 1U) << step;
        EXPECT_EQ(moment->pictures.front().received, ForeignBag::at(step + 0.8));
        const auto* picture = moment->pictures.front().sample.as<PictureSample>();
        ASSERT_TRUE(picture);
        EXPECT_EQ(std::to_integer<int>(picture->content.bytes.front()), ForeignBag::greyOf(step));
        ASSERT_EQ(moment->places->size(), 1U);
        const RobotInMap& place = moment->places->front();
        ASSERT_TRUE(place.placed) << step;
        // Its start is the map's origin, its heading odometry's.
        const Pose way = ForeignBag::baseInRoom(0).inverse() * ForeignBag::baseInRoom(step);
        const Pose turned = poseFrom(Eigen::Vector3d::Zero(), 0, 0, degrees(30));
        EXPECT_LT((place.baseInMap.translation() - turned * way.translation()).norm(), 0.06) << step;
        EXPECT_FALSE(place.trail->empty()) << step;
    }
    EXPECT_THAT(log->problems(), Contains(HasSubstr("7 of its 7 scans")));
    EXPECT_EQ(fingerprint(m_bag), before);
}

TEST_F(ForeignReview, OfTwoScannersTheOneThatSeesAllAroundMakesTheMap) {
    const std::filesystem::path bag = m_folder / "two";
    {
        ForeignBag two(bag);
        two.drive();
        CloudSample depths;
        for (int y = -20; y <= 20; ++y)
            for (int z = -20; z <= 20; ++z)
                depths.points.emplace_back(1.0F, 0.02F * float(y), 0.02F * float(z));
        for (int i = 0; i < 4 * ForeignBag::Steps; ++i) {
            depths.header = {ForeignBag::at(0.1 + 0.25 * i), "rover_depth"};
            two.write(0.1 + 0.25 * i, "/rover/depth/points", depths);
        }
    }
    const auto read = readMissionScans(bag);
    ASSERT_TRUE(read.ok()) << read.error().text;
    EXPECT_EQ(read->scans.size(), Scans);
    for (const ScanPtr& scan : read->scans) EXPECT_GT(scan->points.size(), 2'000U);
    EXPECT_THAT(read->warnings, Contains(HasSubstr("/rover/points")));
}

TEST_F(ForeignReview, EveryStateIsTheSameFromWhereverOneCameToIt) {
    const auto there = ReviewLog::open(m_bag).value(), back = ReviewLog::open(m_bag).value();
    there->makeMap({});
    back->makeMap({});
    const auto moment = [](int number) { return ForeignBag::at(0.43 * number); };
    constexpr int Moments = 30;
    std::vector<std::vector<std::byte>> forwards;
    for (int i = 0; i < Moments; ++i) forwards.push_back(serialised(there->stateAt(moment(i))));
    for (int i = Moments; i-- > 0;)
        EXPECT_TRUE(forwards[static_cast<std::size_t>(i)] == serialised(back->stateAt(moment(i)))) << i;
}

TEST_F(ForeignReview, TellsHowFarItIs) {
    std::mutex mutex;
    std::vector<double> reported;
    ReviewIndexPtr index;
    ReviewListener listener;
    listener.onOpening = [&](double fraction) {
        const std::lock_guard lock(mutex);
        reported.push_back(fraction);
    };
    listener.onIndex = [&](const ReviewIndexPtr& made) {
        const std::lock_guard lock(mutex);
        index = made;
    };
    const auto player = ReviewPlayer::open(m_bag, listener).value();
    ASSERT_TRUE(waitUntil([&] { return player->moment() != nullptr; }, std::chrono::seconds(60)));
    EXPECT_TRUE(player->mapsOffline());
    const std::lock_guard lock(mutex);
    ASSERT_GT(reported.size(), 2 * Scans);
    EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
    EXPECT_LT(reported.front(), 0.1);
    EXPECT_GT(reported.back(), 0.99);
    EXPECT_EQ(index->keyScans.size(), Scans);
}

TEST_F(ForeignReview, StoppedItHasWhatIsRegisteredByThen) {
    const auto log = ReviewLog::open(m_bag).value();
    std::stop_source stop;
    double furthest = 0.0;
    log->makeMap({[&](double fraction) {
                      furthest = std::max(furthest, fraction);
                      if (fraction > 0.6) stop.request_stop();
                  },
                  stop.get_token()});
    EXPECT_LT(furthest, 1.0);
    const std::size_t scans = indexOf(*log)->keyScans.size();
    EXPECT_GE(scans, 1U);
    EXPECT_LT(scans, Scans);
    EXPECT_EQ(log->stateAt(log->last()).keyScans->size(), scans);
}

TEST_F(ForeignReview, NothingIsWrittenIntoIt) {
    const std::string before = fingerprint(m_bag);
    ReviewPen pen(m_bag, {}, "test", "test");
    const auto written = pen.note(ForeignBag::at(3.0), "rover", "a door");
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().text, HasSubstr("nothing can be written into it"));
    EXPECT_EQ(fingerprint(m_bag), before);
}

TEST_F(ForeignReview, ComparingItsMapWithAnotherLeavesNothingInIt) {
    const std::string before = fingerprint(m_bag);
    const auto log = ReviewLog::open(m_bag).value();
    log->makeMap({});
    std::promise<Result<ComparedMapsPtr>> finished;
    MapComparing::Listener listener;
    listener.onFinished = [&](const Result<ComparedMapsPtr>& result) { finished.set_value(result); };
    MapComparing comparing(listener);
    RegistrationSettings settings;
    settings.threads = 1;
    comparing.begin(m_bag, indexOf(*log), settings);
    auto result = finished.get_future();
    ASSERT_EQ(result.wait_for(std::chrono::seconds(60)), std::future_status::ready);
    ASSERT_TRUE(result.get());
    EXPECT_EQ(fingerprint(m_bag), before);
}

TEST_F(ForeignReview, CloudsAloneAreForAWindowOnScans) {
    const auto clouds = m_folder / "clouds", way = m_folder / "way";
    ForeignBag(clouds).sayCloud(0);
    EXPECT_FALSE(isReviewable(clouds));
    {
        ForeignBag bag(way);
        OdometrySample odometry;
        odometry.header = {ForeignBag::at(0.0), "odom"};
        bag.write(0.0, "/rover/odom", odometry);
    }
    EXPECT_FALSE(isReviewable(way)) << "there is nothing to map";
}

}  // namespace
}  // namespace leitstand::test
