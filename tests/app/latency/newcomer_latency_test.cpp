// The demo as `leitstand --demo` opens it, and somebody who drives for the first time.
#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QTest>
#include <QTimer>

#include <gtest/gtest.h>

#include "app/window/live/live_application.h"
#include "app/window/live/live_window.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "core/io/robot/robot_file.h"
#include "tests/app/live/exposed_window.h"
#include "tests/support/dds/robot_listener.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"
#include "tests/transport/dds/test_node.h"
#include "widgets/drive/mode_cell.h"

namespace leitstand::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double MostSeconds = 10.0;    ///< from the window's appearance to the robot's motion
constexpr double GivesUp = 60.0;        ///< [s]
constexpr double Moves = 0.1;           ///< [m], [m/s]
constexpr int Glance = 20, Hand = 250;  ///< how often the newcomer looks, how fast the hand is [ms]

/// Presses F2 as soon as there is a window, and holds W when the strip says nothing against it.
class Newcomer {
public:
    explicit Newcomer(const TestDomain& domain) {
        const RobotDescription kurt = must(readRobot(sourceFolder() + "/resources/robots/kurt3d.yaml"));
        const StreamDescription& odometry = *kurt.stream(StreamRole::Odometry);
        m_topic = odometry.topic;
        NodeSettings network;
        network.interfaces = {"lo"};
        m_node = nodeIn(domain, network);
        m_ears = std::make_unique<RobotListener>(*m_node, std::vector<StreamDescription>{odometry});
        QObject::connect(&m_glance, &QTimer::timeout, [this] { look(); });
        m_glance.start(Glance);
    }
    /// From the window's appearance until the robot moved [s]; nothing when it never did.
    [[nodiscard]] std::optional<double> seconds() const { return m_seconds; }
    /// What the strip said last, for a failure's text.
    [[nodiscard]] const std::string& reported() const { return m_said; }

private:
    void look() {
        LiveWindow* const window = exposedWindow();
        if (window == nullptr || m_done) return;
        if (!m_appeared) {
            m_appeared = Clock::now();
            window->activateWindow();
        }
        const double now = std::chrono::duration<double>(Clock::now() - *m_appeared).count();
        if (moved()) m_seconds = now;
        m_done = m_seconds.has_value() || now > GivesUp;
        if (m_done) {
            if (m_holds) QTest::keyRelease(window, Qt::Key_W);
            window->close();
            return;
        }
        if (!window->driving() && window->isActiveWindow()) QTest::keyClick(window, Qt::Key_F2);
        const auto* const strip = window->findChild<ModeCell*>();
        const QString text = strip->accessibleDescription();
        m_said = text.toStdString();
        if (Clock::now() - m_handMoved < std::chrono::milliseconds(Hand)) return;
        if (!m_holds && isReady(text)) {
            hold(*window, true);
        } else if (m_holds && text.contains(QStringLiteral("must be neutral"))) {
            hold(*window, false);
        }
    }
    /// What a newcomer reads: the grant is there, and nothing stands in the way.
    static bool isReady(const QString& text) {
        for (const char* obstacle :
             {"does not hear", "not on this robot", "must be neutral", "held:", "LOST"}) {
            if (text.contains(QLatin1String(obstacle))) return false;
        }
        return text.contains(QStringLiteral("drive control: yours"));
    }
    void hold(LiveWindow& window, bool on) {
        m_holds = on;
        m_handMoved = Clock::now();
        on ? QTest::keyPress(&window, Qt::Key_W) : QTest::keyRelease(&window, Qt::Key_W);
    }
    [[nodiscard]] bool moved() const {
        const auto received = m_ears->all<OdometrySample>(m_topic);
        if (received.empty()) return false;
        const Eigen::Vector3d way =
            received.back().baseInOdom.translation() - received.front().baseInOdom.translation();
        return received.back().linear.x() > Moves || way.norm() > Moves;
    }

    std::string m_topic, m_said;
    std::unique_ptr<Node> m_node;
    std::unique_ptr<RobotListener> m_ears;
    std::optional<Clock::time_point> m_appeared;
    std::optional<double> m_seconds;
    Clock::time_point m_handMoved;
    bool m_holds = false, m_done = false;
    QTimer m_glance;
};

TEST(NewcomerLatency, DrivesWithinTenSecondsOfTheWindowsAppearance) {
    const TemporaryFolder home;  // nobody's settings and missions are touched
    for (const char* place : {"XDG_CONFIG_HOME", "XDG_DATA_HOME"})
        ASSERT_TRUE(qputenv(place, QByteArray::fromStdString(home.path().string())));
    const TestDomain domain;
    Newcomer newcomer(domain);
    Options options;
    options.live = options.demo = true;
    options.network.domain = domain.number();
    options.mission = (home / "mission").string();
    EXPECT_EQ(runLive(options), 0);
    ASSERT_TRUE(newcomer.seconds().has_value()) << "it never moved; the strip said: " << newcomer.reported();
    std::cout << "drives " << *newcomer.seconds() << " s after the window's appearance\n";
    EXPECT_LE(*newcomer.seconds(), MostSeconds);
}

}  // namespace
}  // namespace leitstand::test
