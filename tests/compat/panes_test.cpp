// Windows on the home of an earlier program: every pane is where its operator left it.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QTest>

#include "app/window/live/live_application.h"
#include "app/window/review/review_application.h"
#include "app/window/scans/scans_window.h"
#include "tests/compat/compat_home.h"
#include "tests/compat/lines.h"
#include "tests/compat/open_window.h"
#include "tests/compat/shown_docks.h"
#include "tests/support/dds/test_domain.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;

QAction& action(const QMainWindow& window, const std::string& id) {
    auto* const found = window.findChild<QAction*>(QString::fromStdString(id));
    if (found == nullptr) throw std::runtime_error("there is no command " + id);
    return *found;
}

class CompatPanes : public CompatHome {
protected:
    /// What is not as it was left, in the first moment in which it differs least: windows take some to lay
    /// out.
    static std::vector<std::string> differences(const QMainWindow& window, const std::string& name) {
        const auto expected = linesOf(compatFile("home-0.2-panes/" + name + ".txt"));
        const auto renamed = linesOf(compatFile("renamed-panes.txt"));
        std::vector<std::string> different;
        (void)QTest::qWaitFor(
            [&] {
                different = dockDifferences(expected, shownDocks(window), renamed);
                return different.empty();
            },
            5'000);
        return different;
    }
    /// Chooses layout @p name in the menu, and looks at all panes.
    static void expectAsLeft(const QMainWindow& window, const std::string& name) {
        action(window, "layout." + name).trigger();
        EXPECT_THAT(differences(panesOf(window), name), testing::IsEmpty()) << "layout " << name;
    }

    const TestDomain m_domain;
};

TEST_F(CompatPanes, OfTheLiveWindowAreAsTheyWereLeft) {
    std::optional<Options> options = lastOptions();
    ASSERT_TRUE(options) << "live.yaml is not understood any more";
    EXPECT_EQ(options->network.domain, 87);
    EXPECT_EQ(options->robots, (std::vector<std::string>{"kurt3d", "tb9"}));
    EXPECT_EQ(options->network.interfaces, std::vector<std::string>{"lo"});
    options->network.domain = m_domain.number();
    options->mission = m_mission.string();
    const std::map<std::string, std::string> log = {{"mission_0.db3", readText(m_mission / "mission_0.db3")},
                                                    {"mission_1.db3", readText(m_mission / "mission_1.db3")}};
    const int status = whileOpen(
        [&] { return runLive(*options); },
        [](QMainWindow& window) {
            EXPECT_EQ(window.geometry(), QRect(60, 40, 1600, 960));
            EXPECT_TRUE(action(window, "layout.bench-left-desk").isChecked()) << "the one that was used last";
            EXPECT_THAT(differences(panesOf(window), "bench-left-desk"), testing::IsEmpty())
                << "as it is opened";
            EXPECT_EQ(action(window, "layout.bench-left-desk").text(), QStringLiteral("Bench, left desk"));
            EXPECT_EQ(action(window, "view.swap").shortcut(), QKeySequence(QStringLiteral("Ctrl+K")));
            EXPECT_EQ(action(window, "layout.arrange").shortcut(),
                      QKeySequence(QStringLiteral("Ctrl+Shift+A")));
            expectAsLeft(window, "swapped");
            EXPECT_EQ(action(window, "view.swap").shortcut(), QKeySequence(Qt::Key_X))
                << "of this layout again";
            expectAsLeft(window, "plan-u00fcberall");
            EXPECT_EQ(action(window, "layout.plan-u00fcberall").text(), QStringLiteral("Plan überall"));
            expectAsLeft(window, "bench-left-desk");
        });
    EXPECT_EQ(status, 0);
    for (const auto& [name, content] : log) EXPECT_TRUE(readText(m_mission / name) == content) << name;
    EXPECT_TRUE(fs::exists(m_mission / "mission_2.db3")) << "the mission was gone on with";
    EXPECT_TRUE(fs::exists(m_mission / "robots/tb9.yaml")) << "the operator's own robot took part";
    EXPECT_THAT(readText(config() / "station.yaml"),
                testing::HasSubstr(linesOf(kept("station.yaml")).front()))
        << "the same station";
    EXPECT_EQ(readText(config() / "brakes.yaml"), readText(kept("brakes.yaml")));
}

TEST_F(CompatPanes, OfTheReviewAreAsTheyWereLeft) {
    Options options;
    options.scans = {m_mission};
    ASSERT_TRUE(wantsReview(options));
    const int status = whileOpen([&] { return runReview(options); },
                                 [](QMainWindow& window) {
                                     EXPECT_EQ(window.geometry(), QRect(60, 40, 1600, 960));
                                     expectAsLeft(window, "jury");
                                 });
    EXPECT_EQ(status, 0);
}

TEST_F(CompatPanes, OfTheScansWindowAreAsTheyWereLeft) {
    const auto run = [] {
        showScansWindow({}, loadWindowState());
        return QApplication::exec();
    };
    const int status = whileOpen(run, [](QMainWindow& window) {
        EXPECT_EQ(window.geometry(), QRect(120, 90, 1500, 880));
        EXPECT_THAT(differences(window, "scans-window"), testing::IsEmpty());
    });
    EXPECT_EQ(status, 0);
}

/// The check itself: it tells the pane that was forgotten, moved or hidden, and lets new ones and new names
/// be.
TEST(CompatDocks, DifferencesNameThePane) {
    const std::vector<std::string> left = {
        "camera left front 0 0 600 1000", "map left front 600 0 400 1000 with scan",
        "scan left behind 0 0 0 0 with map", "link left floating 10 20 300 200"};
    EXPECT_THAT(dockDifferences(left, left, {}), testing::IsEmpty());
    auto more = left;
    more.push_back("new left hidden 0 0 0 0");
    more.front() = "camera left front 0 0 620 1000";
    EXPECT_THAT(dockDifferences(left, more, {}), testing::IsEmpty());
    auto renamed = left;
    renamed[1] = "map left front 600 0 400 1000 with around";
    renamed[2] = "around left behind 0 0 0 0 with map";
    EXPECT_THAT(dockDifferences(left, renamed, {"scan around"}), testing::IsEmpty());
    EXPECT_THAT(dockDifferences(left, renamed, {}),
                testing::UnorderedElementsAre(testing::StartsWith("map: "),
                                              testing::StartsWith("scan: there is no")));
    for (const char* wrong : {"camera left front 0 0 640 1000", "camera left hidden 0 0 0 0",
                              "camera right front 0 0 600 1000", "camera left front 0 0 600 1000 with map"}) {
        auto moved = left;
        moved.front() = wrong;
        EXPECT_THAT(dockDifferences(left, moved, {}), testing::ElementsAre(testing::StartsWith("camera: ")))
            << wrong;
    }
    auto floating = left;
    floating[3] = "link left floating 60 20 300 200";
    EXPECT_THAT(dockDifferences(left, floating, {}), testing::ElementsAre(testing::StartsWith("link: ")));
}

}  // namespace
}  // namespace leitstand::test
