#include "core/station/alarms/alarm_rules.h"

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/result.h"
#include "core/base/unknown.h"
#include "core/event/motion_samples.h"
#include "core/event/station_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/mission/state/robot_state.h"
#include "core/station/alarms/logged_alarm.h"
#include "tests/core/robot/control_scene.h"
#include "tests/support/latest.h"

namespace leitstand::test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// A robot about which nothing is to be told.
struct Calm {
    Calm() {
        description.name = "kurt3d";
        description.title = "Kurt3D";
        description.maxRoll = description.maxPitch = degrees(25);
        view.link.state = LinkState::Connected;
        view.grant.mine = true;
        view.cameras = {{"left", {0.1, 0.1}}};
        tilt(degrees(3), degrees(-5));
        BatterySample battery;
        battery.fraction = 0.7;
        battery.capacity = 10.0;
        battery.current = -7.0;
        reported.battery = latestPtr(Latest<BatterySample>{1, wallAt(-500), battery});
        GasSample gas;
        gas.ppm = 640.0;
        reported.gas = latestPtr(Latest<GasSample>{1, wallAt(-500), gas});
        StreamDescription air;
        air.role = StreamRole::Reading;
        air.topic = "/air";
        air.readings = {{"temperature", "Air", "°C", 1.0, 0.0, {}, {0.0, 45.0, {}, 60.0}},
                        {"cells[0]", "Cell", "V", 1.0, 0.0, {}, {{}, {}, 3.0, {}}}};
        description.streams.push_back(air);
        reported.readings["/air"] = latestPtr(Latest<ReadingSample>{1, wallAt(-500), {{}, {22.0, 3.7}}});
        reported.diagnostics = latestPtr(Latest<DiagnosticsSample>{1, wallAt(-500), {}});
        editable(reported.diagnostics)
            .sample.statuses.push_back(
                {DiagnosticStatus::Level::Warning, "motor_driver", "warm", "kurt3d", {}});
        view.link.clock = ClockStatus{.ahead = milliseconds(900), .uncertainty = milliseconds(20)};
    }
    void tilt(double roll, double pitch) {
        OdometrySample odometry;
        odometry.baseInOdom = poseFrom({1, 2, 0}, roll, pitch, 0.7);
        reported.odometry = latestPtr(Latest<OdometrySample>{1, wallAt(-20), odometry});
    }
    BatterySample& battery() { return editable(reported.battery).sample; }
    [[nodiscard]] std::vector<AlarmCause> causes(const AlarmBook& book = AlarmBook()) const {
        return alarmsOf({description, view, reported, bumpAge, "front_left", spinning}, book, wallAt(0));
    }

    RobotDescription description;
    RobotView view;
    RobotState reported;
    std::optional<double> bumpAge;
    double spinning = 0.0;
};

struct Case {
    const char* what;
    std::function<void(Calm&)> change;
    const char* key;  ///< null: nothing is told
    AlarmSeverity severity = AlarmSeverity::Attention;
    const char* text = "";
};

void PrintTo(const Case& one, std::ostream* out) {
    *out << one.what;
}

class AlarmRule : public testing::TestWithParam<Case> {};

TEST_P(AlarmRule, IsToldSo) {
    Calm robot;
    GetParam().change(robot);
    const auto causes = robot.causes();
    if (GetParam().key == nullptr) {
        EXPECT_TRUE(causes.empty()) << logText(causes.front());
        return;
    }
    ASSERT_EQ(causes.size(), 1u);
    EXPECT_EQ(causes[0].id.key, GetParam().key);
    EXPECT_EQ(causes[0].id.robot, "kurt3d");
    EXPECT_EQ(causes[0].severity, GetParam().severity);
    EXPECT_THAT(logText(causes[0]), testing::HasSubstr(GetParam().text));
}

TEST_P(AlarmRule, IsReadAgainFromTheLog) {
    for (const char* title : {"Kurt3D", "", "Kurt: 3D", "link", "CO2 7 ppm: link lost, silent for 7 s"}) {
        Calm robot;
        robot.description.title = title;
        GetParam().change(robot);
        for (const AlarmCause& cause : robot.causes()) {
            AlarmSample reported;
            reported.robot = cause.id.robot;
            reported.key = logKey(cause.id);
            reported.severity = cause.severity == AlarmSeverity::Act ? AlarmSample::Severity::Critical
                                                                     : AlarmSample::Severity::Warning;
            reported.text = logText(cause);
            const AlarmCause read = loggedCause(reported);
            EXPECT_EQ(read.id, cause.id);
            EXPECT_EQ(read.severity, cause.severity);
            EXPECT_EQ(read.text, reported.text);
            EXPECT_EQ(read.note, cause.note) << reported.text;
            ASSERT_EQ(std::isnan(read.value), std::isnan(cause.value)) << reported.text;
            if (!std::isnan(cause.value)) {
                EXPECT_NEAR(read.value, cause.value, 1e-5 * std::abs(cause.value)) << reported.text;
            }
        }
    }
}

constexpr auto Act = AlarmSeverity::Act;
constexpr auto Look = AlarmSeverity::Attention;

const std::vector<Case>& cases() {
    static const std::vector<Case> all = {Case{"calm", [](Calm&) {}, nullptr},
                    Case{"roll near its limit", [](Calm& r) { r.tilt(degrees(18), 0); }, alarm_key::Attitude,
                         Look, "roll_degrees=18 pitch_degrees=0"},
                    Case{"pitch at its limit", [](Calm& r) { r.tilt(0, degrees(-23)); }, alarm_key::Attitude,
                         Act, "pitch_degrees=-23"},
                    Case{"no limits known",
                         [](Calm& r) {
                             r.description.maxRoll = r.description.maxPitch = 0;
                             r.tilt(degrees(40), 0);
                         },
                         nullptr},
                    Case{"on its side", [](Calm& r) { r.tilt(degrees(85), 0); }, alarm_key::RollOver, Act,
                         "value=1.48353"},
                    Case{"on its back", [](Calm& r) { r.tilt(degrees(180), 0); }, alarm_key::RollOver, Act},
                    Case{"attitude of long ago",
                         [](Calm& r) {
                             r.tilt(degrees(85), 0);
                             editable(r.reported.odometry).received = wallAt(-1'500);
                         },
                         nullptr},
                    Case{"link lost",
                         [](Calm& r) {
                             r.view.link.state = LinkState::Lost;
                             r.view.link.silence = 4.2;
                             r.tilt(degrees(24), 0);  // of then
                         },
                         alarm_key::LinkLost, Act, "link_lost value=4.2"},
                    Case{"never seen", [](Calm& r) { r.view.link.state = LinkState::NeverSeen; }, nullptr},
                    Case{"link degraded",
                         [](Calm& r) {
                             r.view.link.state = LinkState::Degraded;
                             r.view.link.reasons = {{.kind = LinkReason::Kind::Slow, .value = 0.38}};
                         },
                         alarm_key::LinkDegraded, Look, "slow round_trip_ms=380"},
                    Case{"minutes left", [](Calm& r) { r.battery().current = -60.0; }, alarm_key::Battery,
                         Look, "note=minutes"},
                    Case{"hardly any minutes left", [](Calm& r) { r.battery().current = -200.0; },
                         alarm_key::Battery, Act},
                    Case{"little charge, load unknown",
                         [](Calm& r) {
                             r.battery().current = Unknown;
                             r.battery().fraction = 0.18;
                         },
                         alarm_key::Battery, Look, "value=0.18 note=share percent=18"},
                    Case{"no charge",
                         [](Calm& r) {
                             r.battery().current = -0.1;
                             r.battery().fraction = 0.05;
                         },
                         alarm_key::Battery, Act},
                    Case{"charging",
                         [](Calm& r) {
                             r.battery().fraction = 0.05;
                             r.battery().status = BatterySample::Status::Charging;
                         },
                         nullptr},
                    Case{"nothing known of the battery", [](Calm& r) { r.battery() = {}; }, nullptr},
                    Case{"breath", [](Calm& r) { editable(r.reported.gas).sample.ppm = 2'100; }, alarm_key::Gas, Look,
                         "gas value=2100"},
                    Case{"a broken sensor", [](Calm& r) { editable(r.reported.gas).sample.ppm = Unknown; }, nullptr},
                    Case{"heat", [](Calm& r) { editable(r.reported.readings["/air"]).sample.values[0] = 46.0; },
                         alarm_key::Reading, Look, "reading value=46 note="},
                    Case{"fire", [](Calm& r) { editable(r.reported.readings["/air"]).sample.values[0] = 61.0; },
                         alarm_key::Reading, Act, "reading value=61 note="},
                    Case{"a cell", [](Calm& r) { editable(r.reported.readings["/air"]).sample.values[1] = 2.9; },
                         alarm_key::Reading, Act, "reading value=2.9"},
                    Case{"a sensor without a number",
                         [](Calm& r) { editable(r.reported.readings["/air"]).sample.values[0] = Unknown; }, nullptr},
                    Case{"heat of long ago",
                         [](Calm& r) {
                             editable(r.reported.readings["/air"]).sample.values[0] = 61.0;
                             editable(r.reported.readings["/air"]).received = wallAt(-100'000);
                         },
                         nullptr},
                    Case{"a bump", [](Calm& r) { r.bumpAge = 0.4; }, alarm_key::Bump, Look, "bump"},
                    Case{"a bump of before", [](Calm& r) { r.bumpAge = 3.4; }, nullptr},
                    Case{"wheels that spin", [](Calm& r) { r.spinning = 0.84; }, alarm_key::WheelsSpin, Look,
                         "value=0.84"},
                    Case{"wheels that slip", [](Calm& r) { r.spinning = 0.3; }, nullptr},
                    Case{"a part in error",
                         [](Calm& r) {
                             editable(r.reported.diagnostics).sample.statuses[0].level =
                                 DiagnosticStatus::Level::Error;
                         },
                         alarm_key::Diagnostics, Act, "note=warm"},
                    Case{"a frozen picture",
                         [](Calm& r) {
                             r.view.cameras[0].age = {0.1, 2.5};
                         },
                         alarm_key::FrozenPicture, Look, "value=2.5"},
                    Case{"no more pictures",
                         [](Calm& r) {
                             r.view.cameras[0].age = {9.0, 9.0};
                         },
                         nullptr},
                    Case{"a stop just sent",
                         [](Calm& r) {
                             r.view.stop.sent = true;
                             r.view.stop.unanswered = milliseconds(1'900);
                         },
                         nullptr},
                    Case{"a stop without an answer",
                         [](Calm& r) {
                             r.view.stop.sent = true;
                             r.view.stop.unanswered = milliseconds(2'100);
                         },
                         alarm_key::StopUnanswered, Act},
                    Case{"a stop that the robot cannot answer",
                         [](Calm& r) {
                             r.view.stop.supported = false;
                             r.view.stop.sent = true;
                             r.view.stop.unanswered = seconds(9);
                         },
                         nullptr},
                    Case{"a lost grant",
                         [](Calm& r) {
                             r.view.grant = {};
                             r.view.grant.lostTo = "b";
                             r.view.grant.holderTitle = "Van";
                         },
                         alarm_key::GrantLost, Look, "note=Van"},
                    Case{"a clock ahead", [](Calm& r) { r.view.link.clock->ahead = seconds(3); },
                         alarm_key::ClockOffset, Look, "value=3"},
                    Case{"a clock behind", [](Calm& r) { r.view.link.clock->ahead = -seconds(9); },
                         alarm_key::ClockOffset, Look, "value=-9"},
                    Case{"a clock by which a robot drops commands",
                         [](Calm& r) { r.view.link.clock->ahead = -milliseconds(1'020); },
                         alarm_key::ClockOffset, Look, "value=-1.02"},
                    Case{"a clock that is not known well",
                         [](Calm& r) {
                             r.view.link.clock->ahead = seconds(3);
                             r.view.link.clock->uncertainty = milliseconds(2'100);
                         },
                         nullptr}};
    return all;
}

INSTANTIATE_TEST_SUITE_P(Each, AlarmRule, testing::ValuesIn(cases()));

TEST(AlarmRules, EachKeyIsRaisedByACaseAndIsListed) {
    std::set<std::string> raised = {alarm_key::UncertainScan, alarm_key::Log,
                                    alarm_key::NotReceived};  // by others
    for (const Case& one : cases())
        if (one.key != nullptr) raised.insert(one.key);
    EXPECT_THAT(raised, testing::UnorderedElementsAreArray(alarm_key::All));
}

TEST(AlarmRules, WhatStandsTakesMoreToEndThanItTookToBegin) {
    Calm robot;
    AlarmBook book;
    const auto tellFor = [&](double value) {
        editable(robot.reported.gas).sample.ppm = value;
        const auto causes = robot.causes(book);
        book.update(causes, wallAt(0));
        book.update(causes, wallAt(1'000));
        return !causes.empty();
    };
    EXPECT_FALSE(tellFor(1'950));
    EXPECT_TRUE(tellFor(2'010));
    EXPECT_TRUE(tellFor(1'950)) << "it hovers about its limit";
    EXPECT_TRUE(tellFor(1'710));
    EXPECT_FALSE(tellFor(1'690));

    // Attitude comes down from "act" to "look" to nothing.
    Calm tilted;
    AlarmBook other;
    const auto severityAt = [&](double roll) -> std::optional<AlarmSeverity> {
        tilted.tilt(degrees(roll), 0);
        const auto causes = tilted.causes(other);
        other.update(causes, wallAt(0));
        other.update(causes, wallAt(1'000));
        return causes.empty() ? std::nullopt : std::optional(causes[0].severity);
    };
    EXPECT_EQ(severityAt(23), Act);
    EXPECT_EQ(severityAt(20), Act);
    EXPECT_EQ(severityAt(18.5), Look);
    EXPECT_EQ(severityAt(16), Look);
    EXPECT_EQ(severityAt(14), std::nullopt);

    Calm low;
    AlarmBook third;
    low.battery().current = Unknown;
    const auto tellCharge = [&](double share) {
        low.battery().fraction = share;
        const auto causes = low.causes(third);
        third.update(causes, wallAt(0));
        third.update(causes, wallAt(1'000));
        return !causes.empty();
    };
    EXPECT_TRUE(tellCharge(0.19));
    EXPECT_TRUE(tellCharge(0.22));
    EXPECT_FALSE(tellCharge(0.25));
}

}  // namespace
}  // namespace leitstand::test
