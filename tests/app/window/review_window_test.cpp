#include "tests/app/window/review_page.h"

#include <gmock/gmock.h>
#include <QAction>
#include <QComboBox>
#include <QInputDialog>
#include <QLineEdit>
#include <QListView>
#include <QTableView>
#include <QToolButton>

#include "app/services/recorded/review_index.h"
#include "app/services/recorded/review_log.h"
#include "app/services/review/review_pen.h"
#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/layouts/layout_feature.h"
#include "app/window/panes/finds/finds_feature.h"
#include "app/window/review/timeline_feature.h"
#include "core/mission/state/find_state.h"
#include "tests/app/review/written_mission.h"
#include "widgets/camera/camera_pane.h"
#include "widgets/link/stream_list.h"
#include "widgets/map_view/map_view.h"
#include "widgets/timeline/timeline_bar.h"
#include "widgets/virtual_scan/virtual_scan_pane.h"

namespace leitstand::test {
namespace {

using Mission = WrittenMission;
using testing::EndsWith;
using testing::HasSubstr;
using ReviewWindowTest = ReviewPage;

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
    EXPECT_EQ(finds(), 0);
    EXPECT_THAT(label("reviewTime"), EndsWith("0:12.0 of 1:00.0"));
    goTo(47.0);
    EXPECT_TRUE(soon([this] { return label("mapTitle").find("10 key scans") != std::string::npos; }));
    EXPECT_EQ(finds(), 1);
    EXPECT_EQ(found(0, 1), "confirmed");
    goTo(26.0);
    EXPECT_EQ(find<QListView>("alarms").model()->rowCount(), 1);
    EXPECT_EQ(found(0, 1), "unconfirmed");
    lookAt("moment");
}

TEST_F(ReviewWindowTest, ItsStreamsAreThoseOfTheMoment) {
    ASSERT_TRUE(m_window->layouts().use(QStringLiteral("link"))) << m_window->newest().toStdString();
    auto& streams = find<StreamList>("streams");
    ASSERT_TRUE(streams.isVisible());
    const auto text = [&](const char* name, int column) {
        const QAbstractItemModel& model = *streams.model();
        for (int row = 0; row < model.rowCount(); ++row) {
            if (model.index(row, StreamTable::Name).data().toString().endsWith(QLatin1String(name)))
                return model.index(row, column).data().toString().toStdString();
        }
        return std::string("no such stream");
    };
    goTo(47.0);
    EXPECT_TRUE(soon([&] { return text("odometry", StreamTable::Rate) == "10"; }))
        << text("odometry", StreamTable::Rate);
    EXPECT_EQ(text("left pictures", StreamTable::Rate), "2.0");
    EXPECT_EQ(streams.model()->columnCount(), 4) << "what a log does not tell has no column";
    lookAt("link");
    goTo(0.0);
    EXPECT_TRUE(soon([&] { return text("mode", StreamTable::Rate) == "–"; }))
        << text("mode", StreamTable::Rate);
}

TEST_F(ReviewWindowTest, KeysPlayStepAndJump) {
    goTo(0.0);
    press(Qt::Key_N);  // from the start: the mode
    EXPECT_TRUE(stands(0.1));
    press(Qt::Key_F3);
    EXPECT_TRUE(stands(20.0));
    EXPECT_THAT(m_window->newest().toStdString(), EndsWith("K · V1 filed"));
    press(Qt::Key_F3);
    EXPECT_TRUE(stands(45.0));
    press(Qt::Key_F3);
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
    EXPECT_TRUE(soon([this] { return finds() == 1; }));
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
    EXPECT_TRUE(find<QToolButton>("review.undo").isEnabled());
    find<QToolButton>("review.undo").click();
    EXPECT_TRUE(soon([this] {
        return markAfter(m_window->timeline().marks(), Mission::at(32.0))->at == Mission::at(40.0);
    }));
}

TEST_F(ReviewWindowTest, ANoteOfAnEarlierReviewIsTakenBack) {
    TearDown();
    {
        ReviewPen earlier(m_mission, {Mission::robot()}, "review-elsewhere", "test");
        ASSERT_TRUE(earlier.note(Mission::at(33.0), "", "rubble behind the door").ok());
    }
    m_bridge = ReviewBridge::open(m_mission).value();
    openWindow();
    const auto next = [this] {
        const TimelineMark* const mark = markAfter(m_window->timeline().marks(), Mission::at(32.0));
        return mark == nullptr ? Time{} : mark->at;
    };
    ASSERT_TRUE(soon([&] { return next() == Mission::at(33.0); }));
    auto& undo = find<QToolButton>("review.undo");
    ASSERT_TRUE(soon([&] { return undo.isEnabled(); }));
    undo.click();
    EXPECT_TRUE(soon([&] { return next() == Mission::at(40.0); }));
    EXPECT_TRUE(soon([&] { return !undo.isEnabled(); })) << "the rest was recorded";
}

TEST_F(ReviewWindowTest, WhatWasToldIsListedAndReachedByKeys) {
    goTo(33.0);
    m_window->showMessage(QStringLiteral("the first"));
    m_window->showMessage(QStringLiteral("the second"));
    QAction* const command = m_window->commands().find("messages.open");
    ASSERT_NE(command, nullptr);
    EXPECT_EQ(command->shortcut(), QKeySequence(Qt::Key_F4));
    command->trigger();
    EXPECT_TRUE(m_window->panes().isPaneVisible("messages"));
    auto& list = find<QListView>("messages");
    EXPECT_TRUE(soon([&] { return list.hasFocus(); })) << "arrows go through it";
    const int rows = list.model()->rowCount();
    ASSERT_GE(rows, 2);
    const auto text = [&](int row) { return list.model()->index(row, 0).data().toString().toStdString(); };
    EXPECT_THAT(text(rows - 1), EndsWith("the second"));
    EXPECT_THAT(text(rows - 2), EndsWith("the first"));
    lookAt("messages");
}

TEST_F(ReviewWindowTest, ReturnGoesToWhenAFindWasFound) {
    goTo(47.0);
    ASSERT_TRUE(soon([this] { return finds() == 1; }));
    auto& table = find<QTableView>("finds");
    EXPECT_EQ(table.model()->headerData(2, Qt::Horizontal).toString().toStdString(), "Found");
    table.selectRow(0);
    table.setFocus();
    QTest::keyClick(&table, Qt::Key_Return);
    EXPECT_TRUE(stands(45.0)) << "as its newest entry says";
}

TEST_F(ReviewWindowTest, WhatIsWrittenArrivesThoughTheWindowIsMadeAnew) {
    goTo(33.0);
    m_window->finds().askForNote();
    auto& question = find<QInputDialog>("reviewNote");
    question.setTextValue(QStringLiteral("a second language"));
    question.accept();
    openWindow();  // before anything of it could be told
    EXPECT_TRUE(soon([this] { return m_window->newest().contains(QStringLiteral("Noted")); }));
    const TimelineMark* const mark = markAfter(m_window->timeline().marks(), Mission::at(32.0));
    ASSERT_NE(mark, nullptr);
    EXPECT_EQ(mark->text, "a second language");
    EXPECT_TRUE(m_window->commands().find(QStringLiteral("review.undo"))->isEnabled());
}

TEST_F(ReviewWindowTest, AVictimIsCorrectedByItsForm) {
    goTo(47.0);
    m_window->commands().trigger(QStringLiteral("review.finished"));
    ASSERT_TRUE(soon([&] { return finds() == 1; }));
    EXPECT_FALSE(find<QToolButton>("review.form").isEnabled()) << "none is chosen";
    find<QTableView>("finds").selectRow(0);
    find<QToolButton>("review.form").click();
    EXPECT_TRUE(m_window->panes().isPaneVisible(QStringLiteral("form")));
    auto& tag = find<QLineEdit>("tag");
    ASSERT_TRUE(soon([&] { return tag.isEnabled(); }));
    tag.setFocus();
    QTest::keyClicks(&tag, QStringLiteral("Anna"));
    lookAt("form");
    emit tag.editingFinished();
    EXPECT_TRUE(soon([&] { return found(0, 3).find("Anna") != std::string::npos; }));
    auto& situation = find<QComboBox>("situation");
    situation.setCurrentIndex(situation.findData(QStringLiteral("trapped")));
    EXPECT_TRUE(soon([&] { return found(0, 3).find("trapped") != std::string::npos; }));
    find<QToolButton>("review.undo").click();
    EXPECT_TRUE(soon([&] { return found(0, 3).find("trapped") == std::string::npos; }));
    ASSERT_TRUE(soon([&] { return m_window->mapView().settled(); }));
    const QImage marked = m_window->mapView().picture();
    find<QToolButton>("review.discard").click();
    EXPECT_TRUE(soon([&] { return found(0, 1) == "discarded"; }));
    EXPECT_NE(m_window->mapView().picture(), marked) << "its mark goes at once, though nothing is played";
    find<QToolButton>("review.undo").click();
    EXPECT_TRUE(soon([&] { return found(0, 1) == "confirmed"; }));
}

TEST_F(ReviewWindowTest, TheFormShowsWhatWasKnownThenAndTheNewestOnceItIsEdited) {
    TearDown();
    {
        const auto log = ReviewLog::open(m_mission).value();
        FindSample named = indexOf(*log)->finished->finds->begin()->second.victim;
        named.tag = "V-02";
        ReviewPen earlier(m_mission, {Mission::robot()}, "review-elsewhere", "test");
        ASSERT_TRUE(earlier.correct(named).ok());
    }
    m_bridge = ReviewBridge::open(m_mission).value();
    openWindow();
    goTo(30.0);
    ASSERT_TRUE(soon([&] { return finds() == 1; }));
    find<QTableView>("finds").selectRow(0);
    m_window->panes().visibility(QStringLiteral("form"))->trigger();
    auto& tag = find<QLineEdit>("tag");
    ASSERT_TRUE(soon([&] { return tag.isEnabled(); }));
    EXPECT_EQ(tag.text().toStdString(), "") << "nobody had read it by then";
    auto& situation = find<QComboBox>("situation");
    situation.setCurrentIndex(situation.findData(QStringLiteral("trapped")));
    EXPECT_TRUE(soon([&] { return tag.text() == QStringLiteral("V-02"); }));
    EXPECT_EQ(situation.currentData().toString().toStdString(), "trapped");
    const FindSample written = m_bridge->pen().state()->finds->begin()->second.victim;
    EXPECT_EQ(written.situation, "trapped");
    EXPECT_EQ(written.tag, "V-02") << "what was known later stays";
    EXPECT_EQ(written.status, FindSample::Status::Confirmed);
}

TEST_F(ReviewWindowTest, AVictimIsMovedOnTheMapAndMergedOnlyWithWhatIsThere) {
    goTo(47.0);
    m_window->commands().trigger(QStringLiteral("review.finished"));
    ASSERT_TRUE(soon([&] { return finds() == 1; }));
    EXPECT_FALSE(m_window->commands().find(QStringLiteral("review.move"))->isEnabled()) << "none is chosen";
    find<QTableView>("finds").selectRow(0);
    find<QToolButton>("review.merge").click();
    EXPECT_TRUE(m_window->newest().contains(QStringLiteral("no other find")))
        << m_window->newest().toStdString();
    MapView& map = m_window->mapView();
    const Eigen::Vector3d there(2.0, -0.4, 0.0);
    ASSERT_TRUE(soon([&] {
        const auto at = map.project(there);
        return at && map.rect().contains(at->toPoint()) && map.settled();
    }));
    find<QToolButton>("review.move").click();
    EXPECT_TRUE(map.drawing());
    QTest::mouseClick(&map, Qt::LeftButton, {}, map.project(there)->toPoint());
    EXPECT_FALSE(map.drawing());
    const auto away = [&] {
        const MissionStatePtr written = m_bridge->pen().state();
        if (!written) return 99.0;
        return (written->finds->begin()->second.victim.positionInMap - there).head<2>().norm();
    };
    EXPECT_TRUE(soon([&] { return away() < 0.2; })) << away() << " m off";
    EXPECT_TRUE(soon([&] { return m_window->newest().contains(QStringLiteral("moved")); }));
    find<QToolButton>("review.undo").click();
    EXPECT_TRUE(soon([&] { return away() > 0.5; }));
}

TEST_F(ReviewWindowTest, WhatNobodyFiledIsFiledByAClickOnTheMap) {
    goTo(47.0);
    m_window->commands().trigger(QStringLiteral("review.finished"));
    ASSERT_TRUE(soon([&] { return finds() == 1; }));
    MapView& map = m_window->mapView();
    const Eigen::Vector3d there(2.0, -0.4, 0.0);
    ASSERT_TRUE(soon([&] {
        const auto at = map.project(there);
        return at && map.rect().contains(at->toPoint()) && map.settled();
    }));
    QTest::keyClick(m_window.get(), Qt::Key_F, Qt::ShiftModifier);
    ASSERT_TRUE(map.drawing());
    QTest::mouseClick(&map, Qt::RightButton, {}, map.project(there)->toPoint());
    EXPECT_FALSE(map.drawing()) << "not at all";
    EXPECT_EQ(m_window->findChildren<QToolButton*>("review.confirm").size(), 1) << "no button is there twice";
    find<QToolButton>("review.file").click();
    QTest::mouseClick(&map, Qt::LeftButton, {}, map.project(there)->toPoint());
    ASSERT_TRUE(soon([&] { return finds() == 2; })) << m_window->newest().toStdString();
    EXPECT_EQ(found(1, 0), "V2");
    EXPECT_EQ(found(1, 1), "unconfirmed");
    const FindSample filed = m_bridge->pen().state()->finds->at({FindSample::Kind::Victim, 2}).victim;
    EXPECT_LT((filed.positionInMap - there).head<2>().norm(), 0.2);
    EXPECT_EQ(filed.found, m_bridge->reviewed()->now);
    EXPECT_FALSE(filed.evidence.empty()) << "the picture of the moment";
    lookAt("filed");
    find<QToolButton>("review.undo").click();
    EXPECT_TRUE(soon([&] { return finds() == 1; }));
}

TEST_F(ReviewWindowTest, AClickWithShiftIntoThePictureFilesAVictimThere) {
    goTo(47.0);
    m_window->commands().trigger(QStringLiteral("review.finished"));
    ASSERT_TRUE(soon([&] { return finds() == 1; }));
    auto& camera = find<CameraPane>("cameraPane");
    ASSERT_TRUE(soon([&] { return camera.isVisible() && !camera.pictureArea().isEmpty(); }));
    const QPoint middle = camera.pictureArea().center().toPoint();
    QTest::mouseClick(&camera, Qt::LeftButton, Qt::ShiftModifier, middle);
    EXPECT_TRUE(soon([&] { return m_window->newest().contains(QStringLiteral("point to it on the map")); }))
        << "its camera was never calibrated: " << m_window->newest().toStdString();
    EXPECT_EQ(finds(), 1);

    // Beside the robot, in the virtual scan, which needs no camera.
    auto& scan = *m_window->findChild<VirtualScanPane*>();
    ASSERT_TRUE(scan.isVisible());
    QTest::mouseClick(&scan, Qt::LeftButton, Qt::ShiftModifier, scan.rect().center() + QPoint(0, -60));
    ASSERT_TRUE(soon([&] { return finds() == 2; })) << m_window->newest().toStdString();
    EXPECT_EQ(found(1, 1), "unconfirmed");
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
