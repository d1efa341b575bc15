#include "app/services/review/playing/review_player.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/handin/report_source.h"
#include "app/services/thinning/mission_thinning.h"
#include "core/event/map_samples.h"
#include "core/event/scan_bodies.h"
#include "core/event/station_topics.h"
#include "core/mission/state/find_state.h"
#include "tests/app/review/written_mission.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Mission = WrittenMission;
using Kind = TimelineMark::Kind;
using testing::ElementsAre;
using testing::Gt;
using testing::Lt;

double secondsOf(Time at) {
    return std::chrono::duration<double>(at - Mission::begin()).count();
}

class ReviewTest : public testing::Test {
protected:
    void SetUp() override {
        WrittenMission mission(m_mission);
        writeMinute(mission);
    }
    const TemporaryFolder m_folder;
    const std::filesystem::path m_mission = m_folder / "mission";
};

class ReviewSceneTest : public ReviewTest {
protected:
    void SetUp() override {
        ReviewTest::SetUp();
        m_log = ReviewLog::open(m_mission).value();
        m_index = indexOf(*m_log);
        m_scene = std::make_unique<ReviewScene>(*m_log, *m_index);
    }
    [[nodiscard]] ReviewMomentPtr at(double seconds) { return m_scene->at(Mission::at(seconds)); }

    std::unique_ptr<ReviewLog> m_log;
    ReviewIndexPtr m_index;
    std::unique_ptr<ReviewScene> m_scene;
};

TEST_F(ReviewSceneTest, TheIndexMarksWhatHappened) {
    std::vector<std::pair<Kind, double>> marks;
    for (const TimelineMark& mark : m_index->marks) marks.emplace_back(mark.kind, secondsOf(mark.at));
    EXPECT_THAT(marks, ElementsAre(std::pair(Kind::Session, 0.0), std::pair(Kind::Mode, 0.1),
                                   std::pair(Kind::Victim, 20.0), std::pair(Kind::Alarm, 25.0),
                                   std::pair(Kind::Mode, 30.0), std::pair(Kind::Note, 40.0),
                                   std::pair(Kind::Victim, 45.0), std::pair(Kind::Bump, 50.0)));
    EXPECT_THAT(m_index->stretches, ElementsAre(TimelineStretch{Mission::at(0), Mission::at(60)}));
    EXPECT_EQ(m_index->keyScans.size(), 13U);
}

TEST_F(ReviewSceneTest, AMomentHasWhatTheStationHadThen) {
    const ReviewMomentPtr early = at(12.04), late = at(47.0), again = at(12.04);
    EXPECT_EQ(early->mission->finds->size(), 0U);
    EXPECT_EQ(late->mission->finds->size(), 1U);
    EXPECT_EQ(early->scans->scans.size(), 3U);
    EXPECT_EQ(late->scans->scans.size(), 10U);
    EXPECT_EQ(again->map->scans.size(), 3U);
    EXPECT_EQ(early->robots.at("kurt3d").link.state, LinkState::Connected);
    ASSERT_EQ(early->places->size(), 1U);
    const RobotInMap& place = early->places->front();
    EXPECT_TRUE(place.placed);
    EXPECT_NEAR(place.baseInMap.translation().x(), 1.2, 0.011);
    ASSERT_GE(place.trail->size(), 12U);
    EXPECT_NEAR(place.trail->back().inMap.x(), 1.2F, 0.12F);
    ASSERT_EQ(early->pictures.size(), 1U);
    EXPECT_EQ(early->pictures.front().received, Mission::at(12.0));
    EXPECT_EQ(at(12.5)->pictures.front().received, Mission::at(12.5));
}

TEST_F(ReviewSceneTest, TheMapIsAsThenOrAsFinished) {
    const auto third = [](const ReviewMomentPtr& moment) {
        return moment->scans->scans.at(2).pose.scanInMap.translation().x();
    };
    EXPECT_NEAR(third(at(57.0)), 1.0, 1e-9);
    EXPECT_NEAR(third(at(59.0)), 1.5, 1e-9);
    m_scene->show(ReviewMap::Finished);
    const ReviewMomentPtr early = at(11.0);
    EXPECT_EQ(early->scans->scans.size(), 13U);
    EXPECT_NEAR(third(early), 1.5, 1e-9);
    EXPECT_EQ(early->map, at(12.0)->map) << "not made anew";
    // The robot stood beside the third scan, and is corrected as that is.
    EXPECT_NEAR(early->places->front().baseInMap.translation().x(), 1.1 + 0.5, 0.011);
    m_scene->show(ReviewMap::AsThen);
    EXPECT_EQ(at(11.0)->scans->scans.size(), 3U);
}

TEST_F(ReviewSceneTest, OfTheMapIsThereWhatBelongedIntoItThen) {
    const auto folder = m_folder / "cropped";
    std::uint64_t reported = 0;
    {
        WrittenMission mission(folder);
        mission.sayKeyScan(5.0, 1, 0.0);
        MapCropSample crop;
        crop.stamp = Mission::at(9.0);
        crop.station = "test";
        crop.polygon = {{-5.0, -5.0}, {1.0, -5.0}, {1.0, 5.0}, {-5.0, 5.0}};
        mission.publish(9.0, std::string(station_topic::MapCrop), crop);
        reported = mission.sequence();
        mission.sayKeyScan(15.0, 2, 0.5);
        mission.sayUndo(20.0, reported);
        mission.sayKeyScan(25.0, 3, 1.0);
    }
    const auto log = ReviewLog::open(folder).value();
    const auto index = indexOf(*log);
    ReviewScene scene(*log, *index);
    const auto points = [&](double seconds) {
        std::vector<std::size_t> counted;
        const auto moment = scene.at(Mission::at(seconds));
        for (const LiveKeyScan& scan : moment->scans->scans) {
            counted.push_back(scan.scan->points.size());
        }
        return counted;
    };
    const auto whole = points(6.0);
    ASSERT_THAT(whole, ElementsAre(Gt(0U)));
    EXPECT_THAT(points(12.0), ElementsAre(Lt(whole[0]))) << "an area was drawn";
    EXPECT_THAT(points(16.0), ElementsAre(Lt(whole[0]), Lt(whole[0])));
    EXPECT_THAT(points(26.0), ElementsAre(whole[0], whole[0], whole[0])) << "and taken back";
    EXPECT_EQ(points(6.0), whole);
    EXPECT_EQ(scene.at(Mission::at(12.0))->map, scene.at(Mission::at(13.0))->map) << "not made anew";
    scene.show(ReviewMap::Finished);
    EXPECT_THAT(points(12.0), ElementsAre(whole[0], whole[0], whole[0]));
}

TEST_F(ReviewSceneTest, ARobotThatWasPlacedLaterIsInTheMapOnlyUntilThen) {
    const auto folder = m_folder / "placed later";
    {
        WrittenMission mission(folder);
        mission.sayKeyScan(5.0, 1, 0.0);
        BodyInScan all{
            "crawler", {{9.0, 9.0}, {-9.0, 9.0}, {-9.0, -9.0}, {9.0, -9.0}}, 3.0, Pose::Identity(), 0.1};
        all.baseInScan.translation() = Eigen::Vector3d(10.0, 0.0, -1.5);
        mission.publish(9.0, std::string(station_topic::ScanBodies),
                        ScanBodiesSample{Mission::at(9.0), "test", {{1, {all}}}});
    }
    const auto log = ReviewLog::open(folder).value();
    const auto index = indexOf(*log);
    ReviewScene scene(*log, *index);
    const auto points = [&](double seconds) {
        return scene.at(Mission::at(seconds))->scans->scans.front().scan->points.size();
    };
    const std::size_t whole = points(6.0);
    EXPECT_LT(points(9.5), whole);
    EXPECT_EQ(points(6.0), whole) << "it was not known yet";
    scene.show(ReviewMap::Finished);
    EXPECT_LT(points(6.0), whole);
    const auto report = ReportSource::open(folder);
    ASSERT_TRUE(report) << report.error().text;
    ASSERT_EQ(report->input().scans.size(), 1U);
    EXPECT_EQ(report->input().scans.front().scan->points.size(), points(6.0)) << "the report has it, too";
}

TEST_F(ReviewSceneTest, TheTrailHasAGapWhereNothingWasHeardOfTheRobot) {
    const auto folder = m_folder / "gap";
    {
        WrittenMission mission(folder);
        mission.sayKeyScan(0.5, 1, 0.0);
        for (int i = 0; i <= 40; ++i) mission.sayOdometry(1.0 + 0.1 * i, 0.02 * i);
        mission.close();  // the station went away, and the robot drove on
        for (int i = 0; i <= 40; ++i) mission.sayOdometry(30.0 + 0.1 * i, 1.6 + 0.02 * i);
    }
    const auto log = ReviewLog::open(folder).value();
    const auto index = indexOf(*log);
    ReviewScene scene(*log, *index);
    const auto gaps = [&](double seconds) {
        std::vector<float> where;
        const ReviewMomentPtr moment = scene.at(Mission::at(seconds));
        for (const TrailPlace& place : *moment->places->front().trail) {
            if (place.afterGap) where.push_back(place.inMap.x());
        }
        return where;
    };
    EXPECT_TRUE(gaps(5.0).empty());
    EXPECT_THAT(gaps(33.0), ElementsAre(testing::FloatNear(1.6F, 0.01F)));
    EXPECT_FALSE(scene.at(Mission::at(33.0))->places->front().afterGap);
}

TEST_F(ReviewSceneTest, WhatIsAroundIsThereAfterAJumpAndAsOldAsItWas) {
    for (const double seconds : {40.0, 10.0, 10.1, 30.05}) {
        const ReviewMomentPtr moment = at(seconds);
        const auto& around = moment->robots.at("kurt3d").around;
        ASSERT_TRUE(around) << seconds;
        EXPECT_LT(around->nearest(-0.4, 0.4, /*maxAge=*/0.5), 3.0) << seconds;
    }
}

TEST_F(ReviewSceneTest, WhatWasSeenBeforeAJumpIsAroundAsItIsLive) {
    const auto folder = m_folder / "silent";
    {
        WrittenMission mission(folder);
        for (int i = 0; i <= 200; ++i) {
            const double t = 0.1 * i;
            if (i <= 20) mission.sayPlace(t, 0.0);  // then its scanner is silent
            if (i > 20 && i <= 100) mission.sayOdometry(t, 0.0);
            if (i > 100 && i % 10 == 0) mission.sayPicture(t, 100);
        }
    }
    const auto log = ReviewLog::open(folder).value();
    const auto index = indexOf(*log);
    ReviewScene played(*log, *index);
    for (int i = 0; i <= 200; ++i) {
        const Time now = Mission::at(0.1 * i);
        const ReviewMomentPtr moment = played.at(now);
        if (i % 20 != 5) continue;
        ReviewScene jumped(*log, *index);
        const auto around = jumped.at(now)->robots.at("kurt3d").around;
        const auto& expected = moment->robots.at("kurt3d").around;
        ASSERT_TRUE(around && expected) << i;
        ASSERT_EQ(around->sectors.size(), expected->sectors.size());
        for (std::size_t k = 0; k < around->sectors.size(); ++k) {
            EXPECT_EQ(around->sectors[k].age, expected->sectors[k].age) << i << ", " << k;
            EXPECT_EQ(around->sectors[k].outer.has_value(), expected->sectors[k].outer.has_value());
        }
        EXPECT_EQ(std::isfinite(around->youngest()), i <= 140) << "what is older is forgotten";
    }
}

TEST_F(ReviewSceneTest, AMissionWithoutSlicesHasItsKeyScansAround) {
    ASSERT_TRUE(thinMission(m_mission, m_folder / "thin", {}));
    const auto log = ReviewLog::open(m_folder / "thin").value();
    const auto index = indexOf(*log);
    for (const double seconds : {41.5, 10.5, 32.0}) {
        ReviewScene scene(*log, *index);
        const auto around = scene.at(Mission::at(seconds))->robots.at("kurt3d").around;
        ASSERT_TRUE(around) << seconds;
        EXPECT_NEAR(around->youngest(), std::fmod(seconds, 5.0), 0.6) << seconds;
        const double driven = 0.1 * std::fmod(seconds, 5.0);
        double ahead = 0.0;
        for (const VirtualSector& sector : around->sectors)
            if (sector.outer) ahead = std::max(ahead, sector.outer->x());
        EXPECT_NEAR(ahead, 3.0 - driven, 0.05) << seconds;
    }
}

TEST_F(ReviewSceneTest, AlarmsStandAsTheyStood) {
    EXPECT_TRUE(at(24.0)->alarms.empty());
    ASSERT_EQ(at(26.0)->alarms.size(), 1U);
    EXPECT_TRUE(at(26.0)->alarms.front().isLoud());
    EXPECT_EQ(at(26.0)->alarms.front().cause.value, 4.0) << "seconds of silence, as they were logged";
    EXPECT_TRUE(at(30.0)->alarms.front().ended) << "shown for a while after its end";
    EXPECT_TRUE(at(50.0)->alarms.empty());
}

class ReviewPlayerTest : public ReviewTest {
protected:
    void SetUp() override {
        ReviewTest::SetUp();
        m_player = ReviewPlayer::open(m_mission).value();
        ASSERT_TRUE(waitUntil([this] { return m_player->moment() != nullptr; }, 60s));
    }
    [[nodiscard]] bool reaches(double seconds) const {
        return waitUntil([&] { return std::abs(secondsOf(m_player->moment()->now) - seconds) < 1e-6; }, 60s);
    }
    [[nodiscard]] double now() const { return secondsOf(m_player->moment()->now); }

    std::unique_ptr<ReviewPlayer> m_player;
};

TEST_F(ReviewPlayerTest, StandsWhereThereIsSomethingToSeeAndGoesWhereItIsTold) {
    EXPECT_GT(now(), 0.0) << "nothing was heard of any robot there";
    EXPECT_LT(now(), 10.0) << "not later than it must be";
    EXPECT_EQ(m_player->rate(), 0.0);
    m_player->seek(Mission::at(42.0));
    EXPECT_TRUE(reaches(42.0));
    m_player->step(-10s);
    EXPECT_TRUE(reaches(32.0));
    m_player->seek(Mission::at(1e6));
    EXPECT_TRUE(reaches(60.0));
    m_player->seek(Mission::at(-1e6));
    EXPECT_TRUE(reaches(0.0));
}

TEST_F(ReviewPlayerTest, PlaysToTheEndAndBackToTheStart) {
    m_player->seek(Mission::at(40.0));
    m_player->play(32.0);
    EXPECT_TRUE(reaches(60.0));
    EXPECT_TRUE(waitUntil([this] { return m_player->rate() == 0.0; }, 60s));
    m_player->play(-32.0);
    EXPECT_TRUE(reaches(0.0));
    EXPECT_TRUE(waitUntil([this] { return m_player->rate() == 0.0; }, 60s));
    EXPECT_EQ(m_player->moment()->mission->finds->size(), 0U);
}

TEST_F(ReviewPlayerTest, RatesStayWithinTheirBounds) {
    m_player->play(1000.0);
    EXPECT_EQ(m_player->rate(), ReviewPlayer::Fastest);
    m_player->seek(Mission::at(30.0));  // at the beginning it would stop at once
    m_player->play(-0.001);
    EXPECT_EQ(m_player->rate(), -ReviewPlayer::Slowest);
    m_player->play(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(m_player->rate(), 0.0);
}

TEST_F(ReviewPlayerTest, KeepsItsPaceFromATenthToThirtyTwoTimes) {
    using Clock = std::chrono::steady_clock;
    const auto seconds = [](auto span) { return std::chrono::duration<double>(span).count(); };
    for (const double rate : {0.1, 0.5, 8.0, 32.0, -32.0}) {
        const double start = rate > 0.0 ? 4.0 : 56.0;  // 32 times needs 48 of the 60 s
        m_player->seek(Mission::at(start));
        ASSERT_TRUE(reaches(start));
        m_player->play(rate);
        const auto began = Clock::now();
        ASSERT_TRUE(waitUntil([&] { return Clock::now() - began > 1500ms; }, 60s));
        const double passed = seconds(m_player->position() - Mission::at(start));
        const double real = seconds(Clock::now() - began);
        m_player->play(0.0);
        EXPECT_NEAR(passed / real, rate, 0.2 * std::abs(rate));
    }
}

TEST_F(ReviewPlayerTest, PausesWhereItIs) {
    m_player->play(32.0);
    ASSERT_TRUE(waitUntil([this] { return now() > 5.0; }, 60s));
    m_player->play(0.0);
    const Time stands = m_player->position();
    ASSERT_TRUE(waitUntil([&] { return m_player->moment()->now == stands; }, 60s));
    EXPECT_EQ(m_player->position(), stands);
}

TEST(ReviewPlayer, PassesOverTheTimeInWhichNobodyRecorded) {
    const TemporaryFolder folder;
    {
        WrittenMission mission(folder / "mission");
        for (int i = 0; i <= 20; ++i) mission.sayPlace(0.1 * i, 0.0);
        mission.close();
        for (int i = 0; i <= 20; ++i) mission.sayPlace(3600.0 + 0.1 * i, 1.0);
    }
    const auto player = ReviewPlayer::open(folder / "mission").value();
    ASSERT_TRUE(waitUntil([&] { return player->moment() != nullptr; }, 60s));
    player->play(8.0);
    EXPECT_TRUE(waitUntil([&] { return player->moment()->now == player->last(); }, 60s));
    player->play(-8.0);
    EXPECT_TRUE(waitUntil([&] { return player->moment()->now == player->first(); }, 60s));
}

}  // namespace
}  // namespace leitstand::test
