// The preflight page on robots that are not as the shipped ones.
#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QWindow>

#include <gmock/gmock.h>

#include "app/services/station/safety/station_brakes.h"
#include "app/window/input/selection.h"
#include "app/window/live/live_application.h"
#include "app/window/live/preflight/preflight_feature.h"
#include "tests/app/live/live_page.h"
#include "tests/app/station/careless_robot.h"
#include "tests/support/child_process.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"
#include "tests/transport/dds/test_node.h"
#include "widgets/preflight/preflight_page.h"
#include "widgets/robots/robot_chip_button.h"

namespace leitstand::test {
namespace {

using Clock = std::chrono::steady_clock;

/// A robot whose watchdog is missing.
class PreflightOfACarelessRobot : public LivePage {
protected:
    PreflightOfACarelessRobot() : LivePage(Robots::None, {carelessRobot()}) {}

    const std::unique_ptr<Node> m_node = nodeIn(m_domain);
    CarelessRobot m_rover{*m_node, carelessRobot()};
};

TEST_F(PreflightOfACarelessRobot, FailsItsBrakeTestAndABadgeTellsThatItIsDrivenNevertheless) {
    ASSERT_TRUE(soon([&] {
        const auto around = station().surroundings("rover");
        return around && around->oldest(-0.4, 0.4) < 5.0 && robot("rover").drive.reachable;
    }));
    auto* const badge = m_window->findChild<QLabel*>(QStringLiteral("brakeBadge"));
    ASSERT_NE(badge, nullptr);
    EXPECT_FALSE(badge->isVisible());
    press(Qt::Key_F9);
    auto* const page = m_window->findChild<PreflightPage*>();
    ASSERT_TRUE(soon([&] { return page->isVisible() && page->brakeRobot() == "rover"; }));
    auto* const nevertheless = page->findChild<QCheckBox*>(QStringLiteral("override"));
    EXPECT_TRUE(soon([&] { return !nevertheless->isVisible(); })) << "nothing is known against it yet";

    const StationBrakes& brakes = station().brakes();
    auto* const test = page->findChild<QPushButton*>(QStringLiteral("brakeTest"));
    QTest::mousePress(test, Qt::LeftButton);
    EXPECT_TRUE(soon([&] { return brakes.result("rover").verdict != BrakeResult::Verdict::Untested; }));
    QTest::mouseRelease(test, Qt::LeftButton);
    ASSERT_EQ(brakes.result("rover").verdict, BrakeResult::Verdict::Failed);
    ASSERT_TRUE(soon([&] { return nevertheless->isVisible(); }));
    EXPECT_TRUE(brakes.refuses("rover"));
    EXPECT_FALSE(badge->isVisible()) << "nobody drives it";

    nevertheless->click();
    EXPECT_TRUE(soon([&] { return badge->isVisible(); }));
    EXPECT_EQ(badge->text(), "NO WATCHDOG: K") << "its letter";
    EXPECT_TRUE(badge->toolTip().contains("rover"));
    EXPECT_TRUE(badge->toolTip().contains("brake test"));
    EXPECT_FALSE(brakes.refuses("rover"));
    lookAt("no_watchdog");
    nevertheless->click();
    EXPECT_TRUE(soon([&] { return !badge->isVisible(); }));
    EXPECT_TRUE(brakes.refuses("rover"));
}

/// Robots that join from a file, while the station has one.
class PreflightOfAFile : public LivePage {
protected:
    PreflightOfAFile() : LivePage(Robots::None, {shippedRobot("kurt3d")}) {
        press(Qt::Key_F9);
        EXPECT_TRUE(soon([&] { return page().isVisible(); }));
    }
    [[nodiscard]] PreflightPage& page() const { return *m_window->findChild<PreflightPage*>(); }
    [[nodiscard]] std::string complaint() const {
        return page().findChild<QLabel*>(QStringLiteral("complaint"))->text().toStdString();
    }
    /// As the dialog's list is used.
    void choose(const std::string& file) {
        page().findChild<QPushButton*>(QStringLiteral("fromFile"))->click();
        auto* const dialog = page().window()->findChild<QFileDialog*>();
        ASSERT_NE(dialog, nullptr);
        EXPECT_FALSE(dialog->isModal()) << "STOP works meanwhile";
        emit dialog->fileSelected(QString::fromStdString(file));
        delete dialog;
    }
    [[nodiscard]] std::string fileOf(const char* name, const std::string& text) const {
        const std::string file = m_folder.filePath(QLatin1String(name)).toStdString();
        writeText(file, text);
        return file;
    }
};

TEST_F(PreflightOfAFile, AGoodOneIsWantedAndADamagedOneNamesItsLineAndChangesNothing) {
    QStringList wanted;
    QObject::connect(&m_window->preflight(), &PreflightFeature::robotWanted,
                     [&](const QString& file) { wanted += file; });
    const auto team = [&] { return m_window->selection().robots().size(); };
    const std::string good = sourceFolder() + "/resources/robots/crawler.yaml";

    std::string text = readText(good);
    const std::string height = "height: 0.35";
    ASSERT_NE(text.find(height), std::string::npos);
    const auto line = std::count(text.begin(), text.begin() + text.find(height), '\n') + 1;
    const std::string damaged =
        fileOf("damaged.yaml", text.replace(text.find(height), height.size(), "height: tall"));
    choose(damaged);
    EXPECT_THAT(complaint(),
                testing::StartsWith(damaged + ":" + std::to_string(line) + ": height: expected a number"));
    EXPECT_THAT(complaint(), testing::HasSubstr("found \"tall\""));
    choose(fileOf("torn.yaml", readText(good).substr(0, 700)));
    EXPECT_THAT(complaint(), testing::HasSubstr("torn.yaml:"));
    choose(sourceFolder() + "/resources/robots/kurt3d.yaml");
    EXPECT_THAT(complaint(), testing::HasSubstr("two robots are named kurt3d"));
    EXPECT_TRUE(wanted.isEmpty());
    EXPECT_EQ(team(), 1u);
    EXPECT_TRUE(m_window->isVisible());

    choose(good);
    EXPECT_EQ(wanted, QStringList(QString::fromStdString(good)));
}

/// An operator who adds the robot that is heard, and closes the window once it is connected.
class Adder {
public:
    Adder() {
        QObject::connect(&m_glance, &QTimer::timeout, [this] { look(); });
        m_glance.start(100);
    }
    [[nodiscard]] bool connected() const { return m_connected; }
    [[nodiscard]] const std::string& reported() const { return m_said; }  ///< for a failure's text

private:
    void look() {
        LiveWindow* const window = shown();
        if (window == nullptr || m_closed) return;
        const bool joined = window->selection().robots().size() == 2;
        if (joined) m_connected = m_connected || isConnected(*window, "rover");
        if (m_connected || Clock::now() - m_began > std::chrono::minutes(2)) {
            m_closed = true;
            window->close();
            return;
        }
        if (!joined) add(*window);
    }
    void add(LiveWindow& window) {
        auto* const page = window.findChild<PreflightPage*>();
        if (!page->isVisible()) return QTest::keyClick(&window, Qt::Key_F9);
        auto* const received = page->findChild<QComboBox*>(QStringLiteral("stranger"));
        m_said = page->findChild<QLabel*>(QStringLiteral("complaint"))->text().toStdString();
        received->setCurrentIndex(received->findText(QStringLiteral("rover")));
        if (received->currentIndex() < 0) return m_received.reset();
        if (!m_received) m_received = Clock::now();
        // A robot's topics are heard one by one.
        if (Clock::now() - *m_received < std::chrono::seconds(5)) return;
        m_received.reset();
        page->findChild<QPushButton*>(QStringLiteral("add"))->click();
    }
    static bool isConnected(const LiveWindow& window, const char* robot) {
        for (const RobotChipButton* one : window.findChildren<RobotChipButton*>()) {
            if (one->chip().face.name == QLatin1String(robot))
                return one->chip().link == LinkState::Connected;
        }
        return false;
    }
    [[nodiscard]] static LiveWindow* shown() {
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            auto* const window = qobject_cast<LiveWindow*>(widget);
            if (window != nullptr && window->isVisible()) return window;
        }
        return nullptr;
    }

    const Clock::time_point m_began = Clock::now();
    std::optional<Clock::time_point> m_received;
    std::string m_said;
    bool m_connected = false, m_closed = false;
    QTimer m_glance;
};

TEST(PreflightOfAStranger, ARobotThatIsHeardJoinsTheStationWhichGoesOnWithItsMission) {
    const TemporaryFolder home;  // nobody's settings and robots are touched
    for (const char* place : {"XDG_CONFIG_HOME", "XDG_DATA_HOME"})
        ASSERT_TRUE(qputenv(place, QByteArray::fromStdString(home.path().string())));
    const TestDomain domain;
    const ChildProcess rover(program("leitstand-robot"),
                             {"kurt3d", "--arena", "yellow", "--seed", "7", "--name", "rover", "--domain",
                              std::to_string(domain.number())});
    Adder operates;
    Options options;
    options.live = true;
    options.robots = {"kurt3d"};
    options.network.domain = domain.number();
    options.mission = (home / "mission").string();
    EXPECT_EQ(runLive(options), 0);
    EXPECT_TRUE(operates.connected()) << "the page said: " << operates.reported();
    const auto last = lastOptions();
    ASSERT_TRUE(last.has_value());
    ASSERT_EQ(last->robots.size(), 2u) << "it is remembered";
    EXPECT_THAT(last->robots[1], testing::EndsWith("rover.yaml"));
}

}  // namespace
}  // namespace leitstand::test
