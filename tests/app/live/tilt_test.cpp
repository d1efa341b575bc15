// What the operator hears and feels while a robot tilts.
#include <algorithm>
#include <chrono>
#include <vector>

#include <QTimer>

#include <gmock/gmock.h>

#include "app/services/log/sequencer.h"
#include "app/services/station/safety/station_alarms.h"
#include "app/window/panes/alarms/alarms_feature.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "core/mission/state/session_state.h"
#include "robots/wire/robot_wire.h"
#include "tests/app/live/live_page.h"
#include "tests/app/pad/virtual_pad.h"
#include "tests/transport/dds/test_node.h"

namespace leitstand::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Kurt3D as far as its inertial sensor goes.
RobotDescription onlyTilting() {
    RobotDescription robot = shippedRobot("kurt3d");
    std::erase_if(robot.streams, [](const StreamDescription& one) { return one.role != StreamRole::Imu; });
    return robot;
}

class TiltTest : public LivePage {
protected:
    TiltTest()
        : LivePage(Robots::None, {onlyTilting()}),
          m_node(nodeIn(m_domain)),
          m_wire(must(RobotWire::create(*m_node, m_description))) {
        QObject::connect(m_window->findChild<AlarmsFeature*>(), &AlarmsFeature::sounded, &m_beat,
                         [this](AlarmTone tone) { m_received.push_back(tone); });
        QObject::connect(&m_beat, &QTimer::timeout, &m_beat, [this] { publish(); });
        m_beat.start(50);
    }
    void publish() {
        const StreamDescription& stream = *m_description.stream(StreamRole::Imu);
        const auto mounted = m_description.sensors.find(stream.sensor);
        Eigen::Matrix3d baseInLevel = Eigen::AngleAxisd(m_roll, Eigen::Vector3d::UnitX()).toRotationMatrix();
        if (mounted != m_description.sensors.end())
            baseInLevel = baseInLevel * mounted->second.sensorInBase.linear();
        ImuSample imu;
        imu.header = {stationTime(), "kurt3d/imu"};
        imu.orientation = Eigen::Quaterniond(baseInLevel);
        m_wire->publish({StreamRole::Imu, stream.sensor, imu});
    }
    /// @p share of the roll at which it tips over.
    void tilt(double share) { m_roll = share * m_description.maxRoll; }
    [[nodiscard]] std::optional<AlarmSeverity> tilted() const {
        for (const Alarm& one : station().alarms().view().alarms) {
            if (one.cause.id.key == alarm_key::Attitude && !one.ended) return one.cause.severity;
        }
        return std::nullopt;
    }

    const RobotDescription m_description = onlyTilting();
    VirtualPad m_pad;
    std::unique_ptr<Node> m_node;
    std::unique_ptr<RobotWire> m_wire;
    double m_roll = 0.0;
    std::vector<AlarmTone> m_received;
    QTimer m_beat;  ///< last: it ends first
};

TEST_F(TiltTest, IsHeardAndFeltBeforeTheRobotTipsOverAndOverAndOverWhereItIsAboutTo) {
    ASSERT_TRUE(soon([&] { return robot().link.state == LinkState::Connected; }));
    ASSERT_TRUE(soon([this] { return m_window->recent().join("; ").contains("Test pad is plugged in"); }));
    tilt(0.5);
    QTest::qWait(1'000);
    ASSERT_EQ(tilted(), std::nullopt);
    ASSERT_THAT(m_received, IsEmpty());
    const int before = m_pad.rumbles();

    tilt(0.8);
    ASSERT_TRUE(soon([&] { return !m_received.empty(); }));
    EXPECT_EQ(tilted(), AlarmSeverity::Attention);
    QTest::qWait(3'000);
    EXPECT_THAT(m_received, ElementsAre(AlarmTone::Attention)) << "once";
    EXPECT_EQ(m_pad.rumbles(), before + 1);

    tilt(0.95);
    ASSERT_TRUE(soon([&] { return m_received.size() >= 3; })) << "until somebody acknowledges";
    EXPECT_EQ(tilted(), AlarmSeverity::Act);
    EXPECT_EQ(m_received[1], AlarmTone::Act);
    EXPECT_EQ(m_received[2], AlarmTone::Act);
    EXPECT_TRUE(soon([&] { return m_pad.rumbles() >= before + 3; }));

    tilt(0.3);
    ASSERT_TRUE(soon([&] { return !tilted(); }));
    QTest::qWait(500);  // what was on its way
    const std::size_t after = m_received.size();
    QTest::qWait(3'000);
    EXPECT_EQ(m_received.size(), after) << "it stands well again";
}

}  // namespace
}  // namespace leitstand::test
