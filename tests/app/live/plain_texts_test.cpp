// What robots and other stations call themselves and say is shown as it is, never as HTML.
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <QAction>

#include <gmock/gmock.h>

#include "app/services/domain/station_types.h"
#include "app/services/station/safety/station_alarms.h"
#include "app/window/commands/command_table.h"
#include "app/window/layouts/layout_feature.h"
#include "core/event/find_sample.h"
#include "core/event/motion_samples.h"
#include "core/event/sample_header.h"
#include "core/event/station_samples.h"
#include "core/event/station_topics.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/io/robot/robot_file.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/mission_state.h"
#include "tests/app/live/live_page.h"
#include "tests/app/plain_tips.h"
#include "tests/transport/dds/test_node.h"
#include "transport/convert/encode.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

constexpr auto Html = "<b>x</b><img src=\"/etc/hostname\">";
/// As it comes by wire. Files of robots refuse control characters, and HTML but in a title.
constexpr auto Hostile = "<b>x</b><img src=\"/etc/hostname\">\x1b[2J\x07\r\n\xe2\x80\xae";

RobotDescription hostileRobot() {
    RobotDescription robot = shippedRobot("kurt3d");
    robot.title = Html;
    return parseRobot(writeRobot(robot), "hostile.yaml").value();
}

/// What it says on streams that have words; nothing on others.
std::vector<std::pair<StreamRole, Sample>> wordsOfARobot() {
    const SampleHeader header{std::chrono::system_clock::now(), "odom"};
    OdometrySample odometry;
    odometry.header = {header.stamp, Hostile};
    odometry.childFrame = Hostile;
    DiagnosticsSample diagnostics{
        header, {{DiagnosticStatus::Level::Error, Hostile, Hostile, "kurt3d", {{Hostile, Hostile}}}}};
    ModeSample mode{header, Hostile, true, Hostile, {Hostile, "teleoperation"}};
    BumpSample bumps{header, {{Hostile, true, 3}}};
    SightingSample sightings{header, {}};
    for (const char* kind : {"code", "hazard", "victim", Hostile}) {
        Sighting one;
        one.id = static_cast<std::uint32_t>(sightings.sightings.size() + 1);
        one.kind = kind;
        one.text = Hostile;
        one.confidence = 0.9;
        sightings.sightings.push_back(one);
    }
    GasSample gas;
    gas.header = header;
    gas.gas = Hostile;
    BatterySample battery;
    battery.header = header;
    battery.location = Hostile;
    StopStateSample stop{header, 1, Hostile, true, true, Hostile, 1};
    return {{StreamRole::Odometry, odometry},   {StreamRole::Diagnostics, diagnostics},
            {StreamRole::Mode, mode},           {StreamRole::Bumps, bumps},
            {StreamRole::Sightings, sightings}, {StreamRole::Gas, gas},
            {StreamRole::Battery, battery},     {StreamRole::StopState, stop}};
}

/// What another station says.
std::vector<std::pair<std::string_view, Sample>> wordsOfAStation() {
    const Time now = std::chrono::system_clock::now();
    FindSample victim;
    victim.stamp = victim.found = now;
    victim.station = victim.tag = victim.text = victim.situation = victim.area = victim.robot = Hostile;
    victim.number = 2;
    victim.kind = FindSample::Kind::Code;
    AlarmSample alarm;
    alarm.stamp = now;
    alarm.station = alarm.robot = alarm.key = alarm.text = Hostile;
    GrantSample grant;
    grant.stamp = now;
    grant.station = grant.title = Hostile;
    grant.robot = "kurt3d";
    grant.term = 7;
    MissionInfoSample info;
    info.stamp = now;
    info.station = info.competition = info.team = info.country = info.mission = info.area = info.profile =
        Hostile;
    return {{station_topic::Victims, victim},
            {station_topic::Alarms, alarm},
            {station_topic::Grants, grant},
            {station_topic::Mission, info},
            {station_topic::Notes, NoteSample{now, Hostile, Hostile, Hostile}}};
}

/// Says all that again and again, five times a second.
class HostileVoice {
public:
    HostileVoice(const TestDomain& domain, const RobotDescription& robot)
        : m_node(nodeIn(domain, {.name = Hostile})) {
        for (const auto& [role, sample] : wordsOfARobot()) {
            const StreamDescription& stream = *robot.stream(role);
            add({stream.topic, stream.type, stream.qos}, sample);
        }
        for (const auto& [topic, sample] : wordsOfAStation()) {
            for (const StationType& one : StationTypes) {
                if (one.topic == topic)
                    add({std::string(topic), std::string(one.type), transientLocal(10)}, sample);
            }
        }
        m_saying = std::jthread([this](const std::stop_token& stop) {
            while (!stop.stop_requested()) {
                for (const auto& [publisher, payload] : m_words) (void)publisher->write(payload);
                std::this_thread::sleep_for(200ms);
            }
        });
    }

private:
    void add(const WriterSettings& settings, const Sample& sample) {
        m_words.emplace_back(must(m_node->publisher(settings)), must(encode(sample, settings.type)));
    }
    std::unique_ptr<Node> m_node;
    std::vector<std::pair<std::unique_ptr<Publisher>, Payload>> m_words;
    std::jthread m_saying;  ///< last: joined first
};

class HostileRobot : public LivePage {
protected:
    HostileRobot() : LivePage(Robots::None, {hostileRobot()}) {}
    /// Looks at the window as it is now.
    void look(const std::string& where) {
        const QuotedHtml found = quotedHtml(*m_window);
        EXPECT_EQ(found.drawn.join(QStringLiteral("; ")).toStdString(), "") << where;
        m_labels += found.labels;
        m_tips += found.tips;
    }
    int m_labels = 0, m_tips = 0;
};

TEST_F(HostileRobot, ItsWordsAreShownAsTheyAre) {
    const HostileVoice voice(m_domain, hostileRobot());
    ASSERT_TRUE(soon([&] { return robot().link.state == LinkState::Connected; }));
    ASSERT_TRUE(soon([&] { return !station().alarms().view().alarms.empty(); }));
    ASSERT_TRUE(soon([&] { return !station().mission()->finds->empty(); })) << "of the other station";
    for (const char* layout : {"drive", "explore", "map", "link", "report"}) {
        ASSERT_TRUE(m_window->layouts().use(QString::fromLatin1(layout)));
        m_window->showMessage(QString::fromUtf8(Hostile));
        QTest::qWait(500);
        look(layout);
    }
    QAction* const preflight = m_window->commands().find(QStringLiteral("preflight.open"));
    ASSERT_NE(preflight, nullptr);
    preflight->trigger();
    QTest::qWait(500);
    look("preflight");
    EXPECT_GT(m_labels, 5);
    EXPECT_GT(m_tips, 3);
}

}  // namespace
}  // namespace leitstand::test
