#include "app/services/station/safety/station_alarms.h"

#include <algorithm>

#include "core/event/station_samples.h"
#include "core/mission/state/mission_state.h"
#include "core/mission/state/session_state.h"
#include "tests/app/station/seeing_robot.h"
#include "tests/app/station/station_scene.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using State = AlarmSample::State;

class StationAlarmsTest : public StationScene {
protected:
    StationAlarmsTest() { begin(); }
    void begin() { m_station = stationFor({m_description}); }
    [[nodiscard]] std::optional<Alarm> alarm(const std::string& key) const {
        const auto all = m_station->alarms().view().alarms;
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const Alarm& one) { return one.cause.id.key == key; });
        return found == all.end() ? std::nullopt : std::optional(*found);
    }
    [[nodiscard]] bool stands(const std::string& key) const {
        const auto found = alarm(key);
        return found && !found->ended;
    }
    /// As the mission has it.
    [[nodiscard]] std::optional<State> logged(const std::string& key) const {
        const MissionStatePtr mission = m_station->mission();
        for (const auto& [id, state] : *mission->alarms) {
            if (std::get<2>(id) == key) return state.alarm.state;
        }
        return std::nullopt;
    }
    [[nodiscard]] bool connected() {
        return waitUntil([&] { return m_station->robot("kurt3d").link.state == LinkState::Connected; });
    }

    const RobotDescription m_description = seeingRobot();
    const std::unique_ptr<Node> m_node = nodeIn(m_domain);
    std::unique_ptr<SeeingRobot> m_robot = std::make_unique<SeeingRobot>(*m_node, m_description);
    std::unique_ptr<Station> m_station;
};

TEST_F(StationAlarmsTest, ALostLinkIsRaisedAcknowledgedAndEnds) {
    ASSERT_TRUE(connected()) << words();
    EXPECT_FALSE(stands(alarm_key::LinkLost));
    m_robot.reset();
    ASSERT_TRUE(waitUntil([&] { return stands(alarm_key::LinkLost); }));
    EXPECT_TRUE(m_station->alarms().view().loud);
    ASSERT_TRUE(waitUntil([&] { return logged("link_lost") == State::Raised; }));

    m_station->alarms().acknowledge({"kurt3d", alarm_key::LinkLost, ""});
    EXPECT_FALSE(m_station->alarms().view().loud);
    ASSERT_TRUE(waitUntil([&] { return logged("link_lost") == State::Acknowledged; }));
    EXPECT_TRUE(stands(alarm_key::LinkLost)) << "it is still so";

    m_robot = std::make_unique<SeeingRobot>(*m_node, m_description);
    ASSERT_TRUE(waitUntil([&] { return logged("link_lost") == State::Cleared; }));
    EXPECT_FALSE(stands(alarm_key::LinkLost));
}

TEST_F(StationAlarmsTest, FrozenPicturesAreToldOnceAndMutingIsCounted) {
    ASSERT_TRUE(connected()) << words();
    m_robot->pictures = SeeingRobot::Pictures::Frozen;
    ASSERT_TRUE(waitUntil([&] { return stands(alarm_key::FrozenPicture); }));
    EXPECT_EQ(alarm(alarm_key::FrozenPicture)->cause.severity, AlarmSeverity::Attention);
    EXPECT_GE(m_station->alarms().view().attentions, 1u);
    ASSERT_TRUE(waitUntil([&] { return logged("frozen_picture/left") == State::Raised; }));
    m_station->alarms().mute(60s);
    EXPECT_GT(m_station->alarms().view().mutedUntil - alarm(alarm_key::FrozenPicture)->since, 50s);
    m_robot->pictures = SeeingRobot::Pictures::Live;
    ASSERT_TRUE(waitUntil([&] { return !stands(alarm_key::FrozenPicture); }));
}

TEST_F(StationAlarmsTest, WhatAnEarlierSessionLeftStandingEnds) {
    ASSERT_TRUE(connected()) << words();
    m_robot.reset();
    ASSERT_TRUE(waitUntil([&] { return logged("link_lost") == State::Raised; }));
    m_station.reset();
    begin();
    ASSERT_TRUE(waitUntil([&] { return logged("link_lost") == State::Cleared; }));
    EXPECT_FALSE(stands(alarm_key::LinkLost)) << "of this session it was never heard";
}

}  // namespace
}  // namespace leitstand::test
