#include "app/services/comparison/map_comparing.h"

#include <chrono>
#include <future>
#include <mutex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/recorded/review_log.h"
#include "core/event/find_sample.h"
#include "core/event/motion_samples.h"
#include "core/event/status_samples.h"
#include "core/io/settings/comparison_file.h"
#include "core/mission/state/find_state.h"
#include "tests/app/review/written_mission.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using Mission = WrittenMission;

RegistrationSettings oneThread() {
    RegistrationSettings settings;
    settings.threads = 1;
    return settings;
}

const Pose World = poseFrom({5.0, 2.0, 0.1}, 0.0, 0.0, degrees(30.0));

class MapComparingTest : public testing::Test {
protected:
    /// Twenty seconds with five key scans; the third is moved @p wrong ahead in the end.
    void write(bool truth, double wrong = 0.0) {
        WrittenMission mission(m_mission);
        if (truth) {
            SightingSample victims;
            victims.header = {Mission::at(0.0), "arena"};
            Sighting victim;
            victim.id = 1;
            victim.kind = "victim";
            victim.position = World * Eigen::Vector3d(1.0, 0.8, 0.3);
            victims.sightings = {victim};
            mission.publish(0.0, "/truth/test/victims", victims);
        }
        for (int i = 0; i <= 200; ++i) {
            const double t = 0.1 * i;
            mission.sayPlace(t, 0.1 * t);
            if (truth) {
                OdometrySample pose;
                pose.header = {Mission::at(t), "arena"};
                pose.childFrame = "kurt3d/base_link";
                pose.baseInOdom = World * poseFrom({0.1 * t, 0, 0}, 0, 0, 0);
                mission.publish(t, "/truth/test/kurt3d", pose);
            }
            if (i % 50 == 0) mission.sayKeyScan(t, static_cast<std::uint64_t>(i / 50 + 1), 0.1 * t);
            if (i == 100) mission.sayVictim(t, 1, FindSample::Status::Confirmed);
        }
        if (wrong != 0.0) mission.moveKeyScan(20.0, 3, 1.0 + wrong);
        mission.close();
        m_log = ReviewLog::open(m_mission).value();
        m_index = indexOf(*m_log);
    }
    [[nodiscard]] MapComparisonPtr compared() const {
        const auto made = compareMaps(m_mission, *m_index, oneThread());
        EXPECT_TRUE(made) << made.error().text;
        return made ? *made : nullptr;
    }

    const TemporaryFolder m_folder;
    const std::filesystem::path m_mission = m_folder / "mission";
    std::unique_ptr<ReviewLog> m_log;
    ReviewIndexPtr m_index;
};

TEST_F(MapComparingTest, TellsHowFarBothMapsAreFromARecordedTruth) {
    write(true);
    const auto made = compared();
    ASSERT_TRUE(made);
    EXPECT_EQ(made->scans.size(), 5U);
    ASSERT_TRUE(made->recorded.truth && made->again.truth);
    EXPECT_EQ(made->recorded.truth->poses, 5);
    EXPECT_NEAR(made->recorded.truth->position, 0.0, 1e-6);
    EXPECT_NEAR(made->recorded.truth->rotation, 0.0, 1e-6);
    ASSERT_TRUE(made->recorded.finds);
    EXPECT_EQ(made->recorded.finds->finds, 1);
    EXPECT_EQ(made->recorded.finds->found(), 1);
    EXPECT_EQ(made->recorded.finds->missed, 0);
    EXPECT_EQ(made->recorded.finds->wrong, 0);
    EXPECT_NEAR(made->recorded.finds->mean, 0.3, 1e-6);
    EXPECT_NEAR(made->recorded.path, 2.0, 1e-6);
}

TEST_F(MapComparingTest, AScanThatWasMovedWrongShows) {
    write(true, 0.5);
    const auto made = compared();
    ASSERT_TRUE(made && made->recorded.truth);
    // Of five scans one is 0.5 m off; the fit takes a fifth of it.
    EXPECT_NEAR(made->recorded.truth->position, 0.2, 0.01);
}

TEST_F(MapComparingTest, WithoutTruthThereIsNoError) {
    write(false);
    const auto made = compared();
    ASSERT_TRUE(made);
    EXPECT_FALSE(made->recorded.truth || made->again.truth || made->recorded.finds || made->again.finds);
}

TEST_F(MapComparingTest, TheNewestIsKeptWithTheMissionAndComesBack) {
    write(true, 0.5);
    const auto none = keptComparison(m_mission, *m_index);
    ASSERT_TRUE(none);
    EXPECT_EQ(*none, nullptr);
    std::promise<ComparedMapsPtr> done, remembered;
    const auto soon = [](auto& promise) {
        auto result = promise.get_future();
        EXPECT_EQ(result.wait_for(std::chrono::seconds(60)), std::future_status::ready);
        return result.get();
    };
    RegistrationSettings settings = oneThread();
    settings.maxDistances = {1.0, 0.25};
    settings.minimizer = Minimizer::Plane;
    MapComparing first({.onFinished = [&](const auto& result) { done.set_value(*result); }});
    first.begin(m_mission, m_index, settings);
    const MapComparisonPtr made = soon(done)->comparison;
    MapComparing second({.onFinished = [&](const auto& result) { remembered.set_value(*result); }});
    second.recall(m_mission, m_index);
    const ComparedMapsPtr maps = soon(remembered);
    EXPECT_TRUE(maps->remembered);
    const MapComparison& kept = *maps->comparison;
    EXPECT_EQ(kept.settings.minimizer, Minimizer::Plane);
    EXPECT_EQ(kept.settings.maxDistances, settings.maxDistances);
    ASSERT_EQ(kept.scans.size(), made->scans.size());
    for (std::size_t i = 0; i < kept.scans.size(); ++i) {
        EXPECT_EQ(kept.scans[i].scan, made->scans[i].scan) << "points are the mission's own";
        EXPECT_TRUE(kept.scans[i].again.isApprox(made->scans[i].again, 1e-7));
        EXPECT_EQ(kept.scans[i].fitAgain.has_value(), made->scans[i].fitAgain.has_value());
    }
    EXPECT_NEAR(kept.again.rms, made->again.rms, 1e-7);
    EXPECT_NEAR(kept.again.path, made->again.path, 1e-6);
    EXPECT_NEAR(kept.mostMoved, made->mostMoved, 1e-6);
    EXPECT_NEAR(kept.recorded.truth.value().position, made->recorded.truth.value().position, 1e-7);
    ASSERT_TRUE(kept.recorded.finds);
    // Of other scans than those that the mission has, nothing is shown.
    MapComparison other = kept;
    other.scans.back().id = 77;
    ASSERT_TRUE(saveComparison(other, comparisonFileOf(m_mission)));
    const auto wrong = keptComparison(m_mission, *m_index);
    ASSERT_FALSE(wrong);
    EXPECT_THAT(wrong.error().text, testing::HasSubstr("other key scans"));
}

TEST_F(MapComparingTest, RunsOnAThreadOfItsOwnAndIsCancelled) {
    write(false);
    std::promise<ComparedMapsPtr> done, cancelled;
    {
        MapComparing comparing({.onFinished = [&](const auto& result) { done.set_value(*result); }});
        comparing.begin(m_mission, m_index, oneThread());
        auto result = done.get_future();
        ASSERT_EQ(result.wait_for(std::chrono::seconds(60)), std::future_status::ready);
        const ComparedMapsPtr maps = result.get();
        ASSERT_NE(maps, nullptr);
        EXPECT_FALSE(maps->remembered);
        EXPECT_EQ(maps->again->scans.size(), 5U);
        EXPECT_EQ(maps->both->scans.size(), 10U);
    }
    auto begun = std::make_shared<std::promise<void>>();
    auto first = std::make_shared<std::once_flag>();
    auto go = std::make_shared<std::promise<void>>();
    MapComparing comparing({.onProgress =
                                [&, begun, first, go](double) {
                                    std::call_once(*first, [&] {
                                        begun->set_value();
                                        go->get_future().wait();
                                    });
                                },
                            .onFinished = [&](const auto& result) { cancelled.set_value(*result); }});
    comparing.begin(m_mission, m_index, oneThread());
    ASSERT_EQ(begun->get_future().wait_for(std::chrono::seconds(60)), std::future_status::ready);
    comparing.cancel();
    go->set_value();
    auto result = cancelled.get_future();
    ASSERT_EQ(result.wait_for(std::chrono::seconds(60)), std::future_status::ready);
    EXPECT_EQ(result.get(), nullptr);
}

}  // namespace
}  // namespace leitstand::test
