#include <algorithm>
#include <optional>

#include "app/services/station/safety/station_alarms.h"
#include "core/mission/state/mission_state.h"
#include "core/mission/state/session_state.h"
#include "tests/app/station/scanning_scene.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using State = AlarmSample::State;

/// A station whose mapping hears of a robot that drives through the furnished room, at times of its own.
class UncertainScanAlarm : public ScanningScene {
protected:
    UncertainScanAlarm() { m_hearing = {m_station.get()}; }

    [[nodiscard]] bool scans(std::size_t count) {
        return waitUntil([&] { return m_station->mapping().scans()->scans.size() >= count; }, 60s);
    }
    [[nodiscard]] std::optional<Alarm> alarm() const {
        const auto all = m_station->alarms().view().alarms;
        const auto found = std::find_if(all.begin(), all.end(), [](const Alarm& one) {
            return one.cause.id.key == alarm_key::UncertainScan && !one.ended;
        });
        return found == all.end() ? std::nullopt : std::optional(*found);
    }
    /// As the mission has it.
    [[nodiscard]] std::optional<State> logged() const {
        const MissionStatePtr mission = m_station->mission();
        for (const auto& [id, state] : *mission->alarms) {
            if (std::get<2>(id) == alarm_key::UncertainScan) return state.alarm.state;
        }
        return std::nullopt;
    }
    [[nodiscard]] bool raised() {
        return waitUntil([&] { return alarm().has_value() && logged() == State::Raised; });
    }
    [[nodiscard]] bool ended() {
        return waitUntil([&] { return !alarm().has_value() && logged() == State::Cleared; });
    }

    std::unique_ptr<Station> m_station = stationFor({m_description});
};

TEST_F(UncertainScanAlarm, WheelsThatSpinAreToldUntilTheRobotDrivesAgain) {
    ASSERT_TRUE(holdsMap(*m_station)) << words();
    const auto spins = [&] {
        const auto all = m_station->alarms().view().alarms;
        return std::any_of(all.begin(), all.end(), [](const Alarm& one) {
            return one.cause.id.key == alarm_key::WheelsSpin && !one.ended;
        });
    };
    scan();
    scan();
    ASSERT_TRUE(scans(2));
    EXPECT_FALSE(spins());
    for (int i = 0; i < 3; ++i) scan(poseFrom({0.3, 0, 0}, 0, 0, 0), 0.0);  // it pushes against something
    EXPECT_TRUE(waitUntil(spins));
    scan();
    EXPECT_TRUE(waitUntil([&] { return !spins(); }));
}

TEST_F(UncertainScanAlarm, IsRaisedAndEndsWhenTheScanIsRejectedOrAccepted) {
    ASSERT_TRUE(holdsMap(*m_station)) << words();
    scan();
    scan();
    ASSERT_TRUE(scans(2)) << words();
    scan(poseFrom({0.9, -0.7, 0}, 0, 0, degrees(25)));
    ASSERT_TRUE(scans(3)) << words();
    const LiveMapPtr map = m_station->mapping().scans();
    for (const LiveKeyScan& one : map->scans) EXPECT_EQ(one.counts(), one.id < 3) << one.id;
    ASSERT_TRUE(raised()) << words();
    EXPECT_EQ(alarm()->cause.severity, AlarmSeverity::Attention);
    EXPECT_EQ(alarm()->cause.value, 1.0) << "scans";

    ASSERT_TRUE(m_station->mapping().reject(3).ok());
    EXPECT_TRUE(ended()) << words();
    ASSERT_TRUE(m_station->mapping().undo().ok());
    EXPECT_TRUE(raised()) << "it is to be decided on again; " << words();
    ASSERT_TRUE(m_station->mapping().accept(3).ok());
    EXPECT_TRUE(ended()) << words();
    EXPECT_TRUE(m_station->mapping().scans()->scans.back().counts());
}

TEST_F(UncertainScanAlarm, IsRaisedAgainByAnotherScanAfterItWasAcknowledged) {
    ASSERT_TRUE(holdsMap(*m_station)) << words();
    scan();
    scan();
    ASSERT_TRUE(scans(2)) << words();
    scan(poseFrom({0.9, -0.7, 0}, 0, 0, degrees(25)));
    ASSERT_TRUE(raised()) << words();
    m_station->alarms().acknowledge(alarm()->cause.id);
    ASSERT_TRUE(waitUntil([&] { return logged() == State::Acknowledged; })) << words();
    scan();
    ASSERT_TRUE(scans(4)) << words();
    EXPECT_TRUE(raised()) << words();
    EXPECT_EQ(alarm()->cause.value, 2.0) << "scans";
    EXPECT_FALSE(alarm()->acknowledged);
}

}  // namespace
}  // namespace leitstand::test
