#include <atomic>
#include <chrono>
#include <memory>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/victims/victim_search.h"
#include "app/services/victims/victim_watch.h"
#include "core/event/motion_samples.h"
#include "core/event/station_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/robot/robot_description.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

/// Kurt3D says that it read a code ahead of it, three times over.
class SearchForTags : public testing::Test {
protected:
    SearchForTags() {
        m_robot.name = "kurt3d";
        StreamDescription odometry, sightings;
        odometry.role = StreamRole::Odometry;
        sightings.role = StreamRole::Sightings;
        m_robot.streams = {odometry, sightings};
        m_search = std::make_unique<VictimSearch>(std::vector{m_robot}, "us");
        m_search->setTags({{{"dolls", {"doll-*"}}, {"none", {}}}}, "dolls");
        m_search->correct("kurt3d", {at(0), Pose::Identity(), 1.0, true, ""});
    }
    static Time at(int tenths) {
        return Time(std::chrono::seconds(1000) + std::chrono::milliseconds(100 * tenths));
    }
    void receive(StreamRole role, Sample sample) {
        m_search->onEvent({++m_sequence, at(m_now), "kurt3d", "/kurt3d/x", role, "", std::move(sample)});
    }
    /// How many more victims are told after @p text was read.
    int reported(const std::string& text) {
        for (int i = 0; i < 4; ++i, m_now += 10) {
            OdometrySample odometry;
            odometry.header.stamp = at(m_now);
            receive(StreamRole::Odometry, odometry);
            SightingSample sightings;
            sightings.header.stamp = at(m_now);
            Sighting one;
            one.id = ++m_id;
            one.kind = "code";
            one.text = text;
            one.position = {2.0, 0.001 * i, 0.1};
            one.deviation = 0.1;
            one.confidence = 0.9;
            sightings.sightings = {one};
            receive(StreamRole::Sightings, sightings);
        }
        int victims = 0;
        for (const CandidateSample& one : m_search->due(at(m_now)))
            victims += one.kind == FindSample::Kind::Victim && m_reported.insert(one.id).second ? 1 : 0;
        return victims;
    }

    RobotDescription m_robot;
    std::unique_ptr<VictimSearch> m_search;
    std::set<std::uint32_t> m_reported;
    std::uint64_t m_sequence = 0;
    std::uint32_t m_id = 0;
    int m_now = 0;
};

TEST_F(SearchForTags, ATagIsWhatTheProfileThatTheMissionNamesSays) {
    EXPECT_EQ(reported("V-01"), 0);
    EXPECT_EQ(reported("doll-1"), 1);
    MissionInfoSample info;
    info.profile = "none";
    m_search->onEvent({++m_sequence, at(m_now), "", "/leitstand/mission", std::nullopt, "", info});
    EXPECT_EQ(reported("doll-2"), 0) << "by that one no code is a tag";
}

TEST(VictimWatchTags, AProfileThatIsChosenDuringTheMissionIsHeard) {
    RobotDescription robot;
    robot.name = "kurt3d";
    for (const StreamRole role : {StreamRole::Odometry, StreamRole::Sightings}) {
        StreamDescription stream;
        stream.role = role;
        robot.streams.push_back(stream);
    }
    std::atomic<int> victims = 0;
    VictimWatchSetup setup;
    setup.robots = {robot};
    setup.station = "us";
    setup.tags = {{{"dolls", {"doll-*"}}, {"none", {}}}};
    setup.profile = "none";
    setup.onCandidate = [&](const CandidateSample& one) {
        if (one.kind == FindSample::Kind::Victim) ++victims;
    };
    const auto begin =
        std::chrono::time_point_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now());
    RobotInMap there;
    there.robot = "kurt3d";
    there.stamp = begin;
    there.placed = there.certain = true;
    there.certainty = 1.0;
    setup.places = [places = std::make_shared<const std::vector<RobotInMap>>(1, there)] { return places; };
    VictimWatch watch(std::move(setup));
    std::uint64_t sequence = 0;
    MissionInfoSample info;
    info.profile = "dolls";
    watch.onEvent({++sequence, begin, "", "/leitstand/mission", std::nullopt, "", info});
    // Where robots are is followed after what came before.
    ASSERT_TRUE(waitUntil([&] { return watch.waiting() == 0; }, std::chrono::seconds(10)));
    for (int i = 0; i < 6; ++i) {
        const Time now = begin + std::chrono::milliseconds(600 * i);
        OdometrySample odometry;
        odometry.header.stamp = now;
        watch.onEvent({++sequence, now, "kurt3d", "/kurt3d/odom", StreamRole::Odometry, "", odometry});
        SightingSample sightings;
        sightings.header.stamp = now;
        Sighting one;
        one.id = static_cast<std::uint32_t>(i + 1);
        one.kind = "code";
        one.text = "doll-1";
        one.position = {2.0, 0.001 * i, 0.1};
        one.deviation = 0.1;
        one.confidence = 0.9;
        sightings.sightings = {one};
        watch.onEvent({++sequence, now, "kurt3d", "/kurt3d/x", StreamRole::Sightings, "", sightings});
    }
    EXPECT_TRUE(waitUntil([&] { return victims > 0; }, std::chrono::seconds(10)));
    watch.close();
}

}  // namespace
}  // namespace leitstand::test
