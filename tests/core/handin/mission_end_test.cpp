// When a mission was over, for its report.
#include <chrono>

#include <gtest/gtest.h>

#include "core/event/find_sample.h"
#include "core/event/motion_samples.h"
#include "core/event/station_samples.h"
#include "core/event/status_samples.h"
#include "core/handin/report_model.h"
#include "core/mission/state/fold.h"

namespace leitstand::test {
namespace {

Time at(int seconds) {
    return Time(std::chrono::seconds(1'700'000'000 + seconds));
}

/// A mission of a minute, and a review a day later.
struct EndedMission {
    MissionState state;

    void publish(int seconds, const Sample& sample, const std::string& robot = {}) {
        Event event;
        event.sequence = state.sequence + 1;
        event.received = at(seconds);
        event.robot = robot;
        event.topic = robot.empty() ? "/leitstand/own" : "/" + robot + "/topic";
        event.sample = sample;
        state = fold(std::move(state), event);
    }
    void session(int seconds, bool start, const std::string& title) {
        SessionSample session;
        session.stamp = at(seconds);
        session.station = title;
        session.title = title;
        session.start = start;
        publish(seconds, session);
    }
    void drive() {
        session(0, true, "pit");
        ModeSample mode;
        mode.autonomous = true;
        publish(10, mode, "kurt3d");
        publish(50, OdometrySample{}, "kurt3d");
    }
    void file(int seconds) {
        FindSample victim;
        victim.number = 1;
        victim.stamp = at(seconds);
        publish(seconds, victim);
    }
    [[nodiscard]] ReportModel report() const {
        ReportInput input;
        input.state = state;
        input.robots = {"kurt3d"};
        input.modes["kurt3d"] = {{at(10), "explore", true}};
        return reportOf(input);
    }
};

TEST(MissionEnd, AReviewOnAnotherDayAddsNothingToTheTimeOfTheMission) {
    EndedMission mission;
    mission.drive();
    mission.file(58);
    mission.session(60, false, "pit");
    const auto before = mission.report();
    EXPECT_EQ(before.facts.duration, std::chrono::seconds(60));
    mission.session(86'400, true, "Review");
    mission.file(86'410);
    mission.session(86'500, false, "Review");
    const auto after = mission.report();
    EXPECT_EQ(after.facts.end, at(58)) << "what was filed last while it ran";
    EXPECT_EQ(after.facts.duration, std::chrono::seconds(58));
    ASSERT_EQ(after.robots.size(), 1U);
    EXPECT_EQ(after.robots[0].autonomous, std::chrono::seconds(48)) << "it did not drive for a day";
    EXPECT_EQ(after.finds.size(), 1U) << "what the review filed is in it";
}

TEST(MissionEnd, AStationThatIsRestartedGoesOnWithTheMission) {
    EndedMission mission;
    mission.drive();
    mission.session(60, true, "pit");
    mission.publish(90, OdometrySample{}, "kurt3d");
    mission.session(100, false, "pit");
    EXPECT_EQ(mission.report().facts.duration, std::chrono::seconds(100));
}

}  // namespace
}  // namespace leitstand::test
