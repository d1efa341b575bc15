#include "app/window/review/review_window.h"

#include <memory>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <QAction>
#include <QComboBox>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QRadioButton>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include "app/session/layouts/layout_book.h"
#include "app/window/commands/command_table.h"
#include "app/window/live/layouts/layout_feature.h"
#include "app/window/live/pane_docks.h"
#include "app/window/review/finds_feature.h"
#include "app/window/review/review_bridge.h"
#include "app/window/review/timeline_feature.h"
#include "tests/app/review/written_mission.h"
#include "tests/support/temporary_folder.h"
#include "widgets/camera/camera_pane.h"
#include "widgets/map_view/map_view.h"
#include "widgets/timeline/timeline_bar.h"

namespace leitstand::test {
namespace {

using Mission = WrittenMission;
using testing::EndsWith;
using testing::HasSubstr;

/// The review of writeMinute() as an operator sees and uses it.
class ReviewWindowTest : public testing::Test {
protected:
    void SetUp() override {
        {
            WrittenMission mission(m_mission);
            writeMinute(mission);
        }
        m_bridge = ReviewBridge::open(m_mission).value();
        m_window = std::make_unique<ReviewWindow>(
            *m_bridge, MapViewSettings{},
            LayoutBook(m_folder / "layouts", std::string(LEITSTAND_SOURCE_DIR) + "/resources/layouts"));
        m_window->resize(1280, 800);
        m_window->show();
        m_window->activateWindow();  // keys are of the active window
        ASSERT_TRUE(QTest::qWaitForWindowActive(m_window.get()));
        ASSERT_TRUE(soon([this] { return m_bridge->reviewed() != nullptr; }));
    }
    void TearDown() override {
        m_window.reset();
        m_bridge.reset();
    }
    template <class Holds>
    [[nodiscard]] static bool soon(Holds holds) {
        return QTest::qWaitFor(holds, 60'000);
    }
    void goTo(double seconds) {
        m_bridge->player().seek(Mission::at(seconds));
        ASSERT_TRUE(stands(seconds));
    }
    [[nodiscard]] bool stands(double seconds) const {
        return soon([&] { return m_bridge->reviewed()->now == Mission::at(seconds); });
    }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(&m_window->timeline().bar(), key, modifiers);
    }
    [[nodiscard]] std::string label(const char* name) const {
        const auto* const found = m_window->findChild<QLabel*>(QLatin1String(name));
        return found == nullptr ? "there is no such label" : found->text().toStdString();
    }
    template <class T>
    [[nodiscard]] T& find(const char* name) const {
        T* found = m_window->findChild<T*>(QLatin1String(name));
        if (found == nullptr) throw std::runtime_error(std::string("there is no ") + name);
        return *found;
    }
    /// For people: a picture of the window in the folder LEITSTAND_PICTURES.
    void lookAt(const QString& name) {
        const QString folder = qEnvironmentVariable("LEITSTAND_PICTURES");
        if (folder.isEmpty()) return;
        EXPECT_TRUE(soon([&] { return m_window->missing().isEmpty(); }));
        m_window->grab().save(folder + "/review_" + name + ".png");
    }

    const TemporaryFolder m_folder;
    const std::filesystem::path m_mission = m_folder / "mission";
    std::unique_ptr<ReviewBridge> m_bridge;
    std::unique_ptr<ReviewWindow> m_window;
};

TEST_F(ReviewWindowTest, WhatWasSearchedIsAskedForByTheKeysOfTheLiveWindow) {
    goTo(30.0);
    const auto trigger = [this](const char* id) {
        QAction* const command = m_window->commands().find(id);
        ASSERT_NE(command, nullptr) << id;
        command->trigger();
    };
    EXPECT_EQ(m_window->commands().find("coverage.next")->shortcut(),
              QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C));
    EXPECT_EQ(m_window->commands().find("coverage.goTo"), nullptr) << "nobody is there to be sent";
    trigger("coverage.next");
    EXPECT_TRUE(m_window->commands().find("coverage.scanner")->isChecked());
    trigger("coverage.missed");
    EXPECT_TRUE(m_window->panes().isPaneVisible("missed"));
    // The scans of this mission are of walls alone.
    EXPECT_TRUE(soon([this] { return label("missedTitle") == "No floor is known yet"; }));
    lookAt("coverage");
    trigger("coverage.off");
    m_window->layouts().use(QStringLiteral("drive"));
    EXPECT_FALSE(m_window->panes().isPaneVisible("missed"));
    EXPECT_TRUE(soon([this] { return find<QWidget>("cameraPane").width() > m_window->width() / 2; }));
    trigger("coverage.missed");
    const auto& pane = find<QWidget>("missedPane");
    EXPECT_TRUE(soon([&] { return !pane.visibleRegion().isEmpty(); }));
    EXPECT_GT(pane.height(), 100) << "no strip";
    EXPECT_FALSE(find<QWidget>("cameraPane").visibleRegion().isEmpty()) << "the camera stays";
    EXPECT_FALSE(m_window->mapView().visibleRegion().isEmpty()) << "and so does the map, to show places on";
    lookAt("coverage_drive");
}

TEST_F(ReviewWindowTest, EveryPaneFollowsTheMoment) {
    goTo(12.0);
    EXPECT_TRUE(soon([this] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    EXPECT_THAT(label("mapTitle"), HasSubstr("3 key scans"));
    EXPECT_EQ(find<QTreeWidget>("finds").topLevelItemCount(), 0);
    EXPECT_THAT(label("reviewTime"), EndsWith("0:12.0 of 1:00.0"));
    goTo(47.0);
    EXPECT_TRUE(soon([this] { return label("mapTitle").find("10 key scans") != std::string::npos; }));
    EXPECT_EQ(find<QTreeWidget>("finds").topLevelItemCount(), 1);
    EXPECT_EQ(find<QTreeWidget>("finds").topLevelItem(0)->text(1), "confirmed");
    goTo(26.0);
    EXPECT_EQ(find<QListView>("alarms").model()->rowCount(), 1);
    EXPECT_EQ(find<QTreeWidget>("finds").topLevelItem(0)->text(1), "hypothesis");
    lookAt("moment");
}

TEST_F(ReviewWindowTest, KeysPlayStepAndJump) {
    press(Qt::Key_N);  // from the start: the mode
    EXPECT_TRUE(stands(0.1));
    press(Qt::Key_V);
    EXPECT_TRUE(stands(20.0));
    EXPECT_THAT(m_window->newest().toStdString(), EndsWith("K · V1 filed"));
    press(Qt::Key_V);
    EXPECT_TRUE(stands(45.0));
    press(Qt::Key_V);
    EXPECT_TRUE(stands(20.0)) << "round and round";
    press(Qt::Key_A);
    EXPECT_TRUE(stands(25.0));
    press(Qt::Key_P);
    EXPECT_TRUE(stands(20.0));
    press(Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_TRUE(stands(30.0));
    press(Qt::Key_Left);
    EXPECT_TRUE(stands(29.0));
    for (int i = 0; i < 9; ++i) press(Qt::Key_BracketRight);
    press(Qt::Key_Space);
    EXPECT_TRUE(stands(60.0));
    EXPECT_TRUE(soon([this] { return m_bridge->player().rate() == 0.0; }));
    press(Qt::Key_Space, Qt::ShiftModifier);
    EXPECT_TRUE(stands(0.0)) << "backwards to the start";
    press(Qt::Key_End);
    EXPECT_TRUE(stands(60.0));
}

TEST_F(ReviewWindowTest, TheMapIsAsThenOrAsFinished) {
    goTo(11.0);
    EXPECT_TRUE(soon([this] { return label("mapTitle").find("3 key scans") != std::string::npos; }));
    m_window->commands().trigger(QStringLiteral("review.finished"));
    EXPECT_TRUE(soon([this] { return label("mapTitle").find("13 key scans") != std::string::npos; }));
    EXPECT_TRUE(soon([this] { return find<QTreeWidget>("finds").topLevelItemCount() == 1; }));
    lookAt("finished");
    m_window->commands().trigger(QStringLiteral("review.finished"));
    EXPECT_TRUE(soon([this] { return label("mapTitle").find("3 key scans") != std::string::npos; }));
}

TEST_F(ReviewWindowTest, ANoteIsWrittenWhereTheReviewStands) {
    goTo(33.0);
    m_window->commands().trigger(QStringLiteral("review.note"));
    auto& question = find<QInputDialog>("reviewNote");
    EXPECT_FALSE(question.isModal());
    question.setTextValue(QStringLiteral("rubble behind the door"));
    question.accept();
    EXPECT_TRUE(soon([this] { return m_window->newest().contains(QStringLiteral("Noted")); }));
    const auto& marks = m_window->timeline().marks();
    const TimelineMark* const mark = markAfter(marks, Mission::at(32.0));
    ASSERT_NE(mark, nullptr);
    EXPECT_EQ(mark->at, Mission::at(33.0));
    EXPECT_EQ(mark->text, "rubble behind the door");
    EXPECT_TRUE(find<QToolButton>("undoCorrection").isEnabled());
    find<QToolButton>("undoCorrection").click();
    EXPECT_TRUE(soon([this] {
        return markAfter(m_window->timeline().marks(), Mission::at(32.0))->at == Mission::at(40.0);
    }));
}

TEST_F(ReviewWindowTest, AVictimIsCorrectedByItsForm) {
    goTo(47.0);
    m_window->commands().trigger(QStringLiteral("review.finished"));
    auto& finds = find<QTreeWidget>("finds");
    ASSERT_TRUE(soon([&] { return finds.topLevelItemCount() == 1; }));
    finds.setCurrentItem(finds.topLevelItem(0));
    find<QToolButton>("editFind").click();
    EXPECT_TRUE(m_window->panes().isPaneVisible(QStringLiteral("form")));
    auto& tag = find<QLineEdit>("tag");
    ASSERT_TRUE(soon([&] { return tag.isEnabled(); }));
    QTest::keyClicks(&tag, QStringLiteral("Anna"));
    lookAt("form");
    emit tag.editingFinished();
    EXPECT_TRUE(soon([&] { return finds.topLevelItem(0)->text(3).contains(QStringLiteral("Anna")); }));
    auto& situation = find<QComboBox>("situation");
    situation.setCurrentIndex(situation.findData(QStringLiteral("trapped")));
    EXPECT_TRUE(soon([&] { return finds.topLevelItem(0)->text(3).contains(QStringLiteral("trapped")); }));
    find<QToolButton>("undoCorrection").click();
    EXPECT_TRUE(soon([&] { return !finds.topLevelItem(0)->text(3).contains(QStringLiteral("trapped")); }));
    find<QToolButton>("discardFind").click();
    EXPECT_TRUE(soon([&] { return finds.topLevelItem(0)->text(1) == QStringLiteral("discarded"); }));
    find<QToolButton>("undoCorrection").click();
    EXPECT_TRUE(soon([&] { return finds.topLevelItem(0)->text(1) == QStringLiteral("confirmed"); }));
}

TEST_F(ReviewWindowTest, TheMapRegisteredAgainIsShownBesideTheRecordedOne) {
    goTo(47.0);
    m_window->commands().trigger(QStringLiteral("review.compare"));
    EXPECT_TRUE(m_window->panes().isPaneVisible(QStringLiteral("compare")));
    auto& distances = find<QLineEdit>("compareDistances");
    auto& begin = find<QToolButton>("beginComparison");
    distances.setText(QStringLiteral("far"));
    EXPECT_FALSE(begin.isEnabled());
    distances.setText(QStringLiteral("1.0, 0.5"));
    EXPECT_FALSE(find<QRadioButton>("mapAgain").isEnabled()) << "there is none yet";
    begin.click();
    auto& figures = find<QTableView>("comparisonFigures");
    ASSERT_TRUE(soon([&] { return figures.model()->rowCount() > 0; })) << m_window->newest().toStdString();
    EXPECT_THAT(m_window->newest().toStdString(), HasSubstr("13 key scans registered again"));
    EXPECT_EQ(find<QTableView>("comparisonScans").model()->rowCount(), 13);
    int shown = 0;
    QObject::connect(m_bridge.get(), &MomentSource::mapChanged, m_window.get(),
                     [&shown](const MapPtr& map) { shown = static_cast<int>(map->scans.size()); });
    find<QRadioButton>("mapBoth").click();
    EXPECT_EQ(shown, 26);
    lookAt("compared");
    goTo(12.0);
    EXPECT_EQ(shown, 26) << "it stays while the moment changes";
    find<QRadioButton>("mapAgain").click();
    EXPECT_EQ(shown, 13);
    find<QRadioButton>("mapRecorded").click();
    EXPECT_EQ(shown, 3) << "as then";
}

TEST_F(ReviewWindowTest, NothingOffersToMoveARobot) {
    for (const char* id : {"robot.stop", "robot.drive", "map.goTo", "camera.left", "camera.snapshot"})
        EXPECT_EQ(m_window->commands().find(QLatin1String(id)), nullptr) << id;
    for (const char* layout : {"drive", "explore", "map", "review"})
        EXPECT_TRUE(m_window->layouts().use(QLatin1String(layout))) << m_window->newest().toStdString();
    EXPECT_TRUE(m_window->panes().isPaneVisible(QStringLiteral("finds")));
}

}  // namespace
}  // namespace leitstand::test
