#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>

#include <QAction>
#include <QFrame>

#include <gtest/gtest.h>

#include "app/services/station/station.h"
#include "app/window/commands/command_table.h"
#include "app/window/layouts/layout_feature.h"
#include "core/io/robot/editing/robot_edits.h"
#include "core/io/robot/robot_file.h"
#include "tests/app/live/live_page.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"
#include "widgets/map_view/map_view.h"

namespace leitstand::test {
namespace {

/// A robot's file that an engineer got wrong: Kurt3D's scanner measures right, and it says 5 cm too short.
struct WrongFile {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder / "kurt3d.yaml";
    /// A hall in which nothing keeps a robot from driving about.
    const std::filesystem::path hall = folder / "hall.yaml";
    WrongFile() {
        std::ofstream(hall) << R"(name: hall
from: [-5, -3]
to: [5, 3]
starts:
  kurt3d: {position: [-4, 1, 0]}
  crawler: {position: [-4, -2, 0]}
elements:
  - {kind: floor, position: [0, 0, 0], size: [10, 6, 0.1]}
  - {kind: wall, name: north, position: [0, 3, 0], size: [10, 0.05, 2.5]}
  - {kind: wall, name: south, position: [0, -3, 0], size: [10, 0.05, 2.5]}
  - {kind: wall, name: east, position: [5, 0, 0], turn: [0, 0, 90], size: [6, 0.05, 2.5]}
  - {kind: wall, name: west, position: [-5, 0, 0], turn: [0, 0, 90], size: [6, 0.05, 2.5]}
  - {kind: wall, name: middle, position: [0, -1.5, 0], turn: [0, 0, 60], size: [1, 0.3, 2.5]}
)";
        std::ifstream shipped(sourceFolder() + "/resources/robots/kurt3d.yaml");
        const std::string text{std::istreambuf_iterator<char>(shipped), std::istreambuf_iterator<char>()};
        std::ofstream(path) << withCorrection(text, "kurt3d.yaml", "scanner", {0.05, 0.0, 0.0}).value();
    }
};

class ScannerQuestionOnScreen : public LivePage {
protected:
    ScannerQuestionOnScreen() : ScannerQuestionOnScreen(std::make_unique<WrongFile>()) {}
    explicit ScannerQuestionOnScreen(std::unique_ptr<WrongFile> file)
        : LivePage(Robots::None, {readRobot(file->path).value(), shippedRobot("crawler")}),
          m_file(std::move(file)) {
        startRobots(QString::fromStdString(m_file->hall.string()));
        m_window->layouts().use("map");
    }
    const std::unique_ptr<WrongFile> m_file;
};

TEST_F(ScannerQuestionOnScreen, AWrongScannerIsAskedAboutOverTheMapAndCorrectedInItsFile) {
    station().requestGrant("kurt3d");
    ASSERT_TRUE(soon([&] { return robot().grant.mine; }));
    ASSERT_TRUE(station().setMode("kurt3d", "explore").ok());
    auto* const asked = m_window->findChild<QFrame*>("scannerQuestion");
    ASSERT_NE(asked, nullptr);
    EXPECT_FALSE(asked->isVisible());
    QAction* const use = m_window->commands().find("scanner.use");
    ASSERT_NE(use, nullptr);
    EXPECT_FALSE(use->isEnabled());
    ASSERT_TRUE(QTest::qWaitFor([&] { return asked->isVisible(); }, 3 * Patience)) << "nothing is asked";
    const QString question = asked->accessibleName();
    EXPECT_TRUE(question.contains("Kurt3D: its 3D scanner measures ")) << question.toStdString();
    EXPECT_TRUE(question.contains(" cm too far. Correct that?")) << question.toStdString();
    EXPECT_TRUE(asked->parentWidget()->rect().contains(asked->geometry())) << "nothing of it is cut";
    lookAt("scanner_question");
    ASSERT_TRUE(use->isEnabled());
    use->trigger();
    EXPECT_TRUE(soon([&] { return !asked->isVisible(); }));
    EXPECT_FALSE(use->isEnabled());
    const auto corrected = readRobot(m_file->path);
    ASSERT_TRUE(corrected.ok()) << corrected.error().text;
    EXPECT_LT(std::abs(corrected->sensors.at("scanner").correction.range), 0.02)
        << "most of what was wrong is gone; where a centimetre is left it is asked about again";
    station().stopAll();
    EXPECT_TRUE(soon([&] { return robot().stop.standing; }));
}

}  // namespace
}  // namespace leitstand::test
