// A stock robot that nobody described, and an engineer who connects it: by what the preflight page offers.
#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QComboBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>

#include <gtest/gtest.h>

#include "app/window/input/selection.h"
#include "app/window/live/live_application.h"
#include "app/window/live/live_window.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "tests/app/live/exposed_window.h"
#include "tests/support/child_process.h"
#include "tests/support/dds/robot_listener.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"
#include "tests/transport/dds/test_node.h"
#include "widgets/drive/mode_cell.h"
#include "widgets/preflight/preflight_page.h"
#include "widgets/robots/robot_chip_button.h"

namespace leitstand::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double MostSeconds = 15.0;    ///< from the window's appearance, with the robot there, to its motion
constexpr int MostClicks = 3;           ///< with the mouse
constexpr double GivesUp = 90.0;        ///< [s]
constexpr double Turns = 0.2;           ///< [rad/s]
constexpr int Glance = 20, Hand = 250;  ///< how often the engineer looks, how fast the hand is [ms]

/// A stock robot, as probe and preflight name it.
struct Stock {
    const char *profile, *name, *odometry;
};

/// Opens the preflight page, adds the robot that is heard, selects it, and turns it on the spot with D.
class Engineer {
public:
    Engineer(const TestDomain& domain, const Stock& stock) : m_stock(stock), m_node(nodeIn(domain)) {
        StreamDescription odometry;
        odometry.role = StreamRole::Odometry;
        odometry.topic = stock.odometry;
        odometry.type = "nav_msgs/msg/Odometry";
        odometry.qos.reliability = Qos::Reliability::BestEffort;
        m_ears = std::make_unique<RobotListener>(*m_node, std::vector<StreamDescription>{odometry});
        QObject::connect(&m_glance, &QTimer::timeout, [this] { look(); });
        m_glance.start(Glance);
    }
    [[nodiscard]] std::optional<double> seconds() const { return m_seconds; }
    [[nodiscard]] int clicks() const { return m_clicks; }
    [[nodiscard]] const std::string& reported() const { return m_said; }  ///< for a failure's text

private:
    void look() {
        LiveWindow* const window = exposedWindow();
        if (window == nullptr || m_done) return;
        if (!m_appeared) m_appeared = Clock::now();
        const double now = std::chrono::duration<double>(Clock::now() - *m_appeared).count();
        const auto odometry = m_ears->all<OdometrySample>(m_stock.odometry);
        if (!odometry.empty() && std::abs(odometry.back().angular.z()) > Turns) m_seconds = now;
        m_done = m_seconds.has_value() || now > GivesUp;
        if (m_done) {
            if (m_holds) QTest::keyRelease(window, Qt::Key_D);
            window->close();
            return;
        }
        if (Clock::now() - m_handMoved < std::chrono::milliseconds(Hand)) return;
        if (window->selection().robots().size() < 2) return add(*window);
        drive(*window);
    }
    void add(LiveWindow& window) {
        auto* const page = window.findChild<PreflightPage*>();
        if (!page->isVisible()) return press(window, Qt::Key_F9);
        const auto* const heard = page->findChild<QComboBox*>(QStringLiteral("stranger"));
        m_said = "the page offers: " + heard->currentText().toStdString();
        if (heard->currentText() != QLatin1String(m_stock.name)) return;
        click(*page->findChild<QPushButton*>(QStringLiteral("add")));
    }
    void drive(LiveWindow& window) {
        if (!window.isActiveWindow()) return window.activateWindow();
        if (window.selection().name() != QLatin1String(m_stock.name)) {
            for (RobotChipButton* const chip : window.findChildren<RobotChipButton*>())
                if (chip->chip().face.name == QLatin1String(m_stock.name)) return click(*chip);
            return;
        }
        const QString text = window.findChild<ModeCell*>()->accessibleDescription();
        m_said = "the strip said: " + text.toStdString();
        if (!window.driving()) return press(window, Qt::Key_F2);
        if (m_holds && text.contains(QStringLiteral("must be neutral"))) return hold(window, false);
        if (!m_holds && text.contains(QStringLiteral("drive control: yours"))) hold(window, true);
    }
    void click(QWidget& widget) {
        ++m_clicks;
        m_handMoved = Clock::now();
        QTest::mouseClick(&widget, Qt::LeftButton);
    }
    void press(QWidget& window, Qt::Key key) {
        m_handMoved = Clock::now();
        QTest::keyClick(&window, key);
    }
    void hold(QWidget& window, bool on) {
        m_holds = on;
        m_handMoved = Clock::now();
        on ? QTest::keyPress(&window, Qt::Key_D) : QTest::keyRelease(&window, Qt::Key_D);
    }

    const Stock m_stock;
    std::unique_ptr<Node> m_node;
    std::unique_ptr<RobotListener> m_ears;
    std::string m_said;
    std::optional<Clock::time_point> m_appeared;
    std::optional<double> m_seconds;
    Clock::time_point m_handMoved;
    int m_clicks = 0;
    bool m_holds = false, m_done = false;
    QTimer m_glance;
};

/// An arena where nothing stands nearer than a lidar can see.
std::string hall(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / "hall.yaml";
    writeText(file, R"(
name: hall
from: [-3, -3]
to: [3, 3]
starts:
  kurt3d: {position: [0, 0, 0]}
  crawler: {position: [0, 0, 0]}
elements:
  - {kind: floor, position: [0, 0, 0], size: [6, 6, 0.1]}
  - {kind: wall, name: north, position: [0, 3, 0], size: [6, 0.05, 2.5]}
  - {kind: wall, name: south, position: [0, -3, 0], size: [6, 0.05, 2.5]}
  - {kind: wall, name: east, position: [3, 0, 0], turn: [0, 0, 90], size: [6, 0.05, 2.5]}
  - {kind: wall, name: west, position: [-3, 0, 0], turn: [0, 0, 90], size: [6, 0.05, 2.5]}
)");
    return file.string();
}

void drivesWithin(const Stock& stock) {
    const TemporaryFolder home;  // nobody's settings and missions are touched
    for (const char* place : {"XDG_CONFIG_HOME", "XDG_DATA_HOME"})
        ASSERT_TRUE(qputenv(place, QByteArray::fromStdString(home.path().string())));
    const TestDomain domain;
    const ChildProcess robot(
        program("leitstand-robot"),
        {"stock", stock.profile, "--domain", std::to_string(domain.number()), "--arena", hall(home.path())});
    ASSERT_TRUE(
        waitUntil([&] { return robot.out().find(" is in ") != std::string::npos; }, std::chrono::minutes(1)))
        << robot.out();
    Engineer engineer(domain, stock);
    Options options;
    options.live = true;
    options.robots = {"crawler"};
    options.network.domain = domain.number();
    options.mission = (home / "mission").string();
    EXPECT_EQ(runLive(options), 0);
    ASSERT_TRUE(engineer.seconds().has_value()) << "it never moved; " << engineer.reported();
    std::cout << stock.profile << ": driven after " << *engineer.seconds() << " s and " << engineer.clicks()
              << " clicks\n";
    EXPECT_LE(*engineer.seconds(), MostSeconds);
    EXPECT_LE(engineer.clicks(), MostClicks);
}

TEST(StockRobotLatency, AHuskyIsDrivenWithoutAFileByHand) {
    drivesWithin({"husky", "a200_0000", "/a200_0000/platform/odom"});
}

TEST(StockRobotLatency, ATurtleBot4IsDrivenWithoutAFileByHand) {
    drivesWithin({"turtlebot4", "robot", "/odom"});
}

TEST(StockRobotLatency, OneWithAnOusterIsDrivenWithoutAFileByHand) {
    drivesWithin({"ouster", "robot", "/odom"});
}

TEST(StockRobotLatency, OneWithALivoxIsDrivenWithoutAFileByHand) {
    drivesWithin({"livox", "robot", "/odom"});
}

TEST(StockRobotLatency, ATrackedOneIsDrivenWithoutAFileByHand) {
    drivesWithin({"tracked", "robot", "/odom"});
}

}  // namespace
}  // namespace leitstand::test
