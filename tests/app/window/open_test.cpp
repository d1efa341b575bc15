#include <gmock/gmock.h>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QDropEvent>
#include <QFileDialog>
#include <QListView>
#include <QMenu>
#include <QMimeData>
#include <QUrl>

#include "tests/app/services/scan_folder.h"
#include "tests/app/window/window_page.h"

namespace leitstand {
namespace {

using test::eventually;
using test::WindowPage;
using test::WindowTest;
using testing::HasSubstr;
using testing::StartsWith;

class OpenTest : public WindowTest {};

TEST_F(OpenTest, AnEmptyWindowSaysWhatToDo) {
    WindowPage page;
    page.waitUntilShown();
    EXPECT_TRUE(page.find<QWidget>("help").isVisible());
    EXPECT_THAT(page.label("help"), HasSubstr("Ctrl+O"));
    EXPECT_FALSE(page.action("again").isEnabled());
    EXPECT_FALSE(page.action("savePicture").isEnabled());
}

TEST_F(OpenTest, AFolderIsRegisteredShownAndSummedUp) {
    WindowPage page;
    page.openAndWait({drive()});
    EXPECT_EQ(page.scans().model()->rowCount(), 3);
    EXPECT_EQ(page.cell(0, ScanListModel::Certainty), "reference");
    EXPECT_EQ(page.cell(2, ScanListModel::Certainty), "certain");
    EXPECT_THAT(page.cell(2, ScanListModel::Position), StartsWith("0.6"));
    EXPECT_THAT(page.label("mapTitle"), StartsWith("3D map · 3 scans · "));
    EXPECT_THAT(page.label("mapResult"), testing::MatchesRegex("registered in .* s · overlap .* · certain"));
    EXPECT_FALSE(page.find<QWidget>("help").isVisible());
    EXPECT_FALSE(page.find<QWidget>("progress").isVisible());
    EXPECT_TRUE(page.action("again").isEnabled());
}

TEST_F(OpenTest, ABrokenFileStandsInTheMessagesAndTheOthersAreShown) {
    const auto folder = drive();
    test::writeText(folder / "scan001.3d", "no scan at all\n");
    WindowPage page;
    EXPECT_FALSE(page.find<QDockWidget>("messagesDock").isVisible());
    page.openAndWait({folder});
    EXPECT_EQ(page.scans().model()->rowCount(), 2);
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    EXPECT_TRUE(page.find<QDockWidget>("messagesDock").isVisible());
    auto& list = page.find<QListView>("messages");
    ASSERT_EQ(list.model()->rowCount(), 1);
    EXPECT_THAT(list.model()->index(0, 0).data().toString().toStdString(), HasSubstr("scan001.3d:1"));
    EXPECT_EQ(page.find<QAbstractButton>("messageCount").text().toStdString(), "▲ 1 error");
    list.setFocus();
    list.setCurrentIndex(list.model()->index(0, 0));
    page.press(Qt::Key_Delete);
    EXPECT_EQ(list.model()->rowCount(), 0);
    EXPECT_EQ(page.find<QAbstractButton>("messageCount").text().toStdString(), "No messages");
}

TEST_F(OpenTest, AFolderDroppedOnTheWindowIsOpened) {
    const auto folder = drive();
    WindowPage page;
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(QString::fromStdString(folder.string()))});
    QDragEnterEvent enter({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&page.window(), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&page.window(), &drop);
    EXPECT_TRUE(drop.isAccepted());
    page.waitUntilShown();
    EXPECT_EQ(page.scans().model()->rowCount(), 3);
}

TEST_F(OpenTest, WhatIsNoFileCannotBeDropped) {
    WindowPage page;
    QMimeData data;
    data.setText(QStringLiteral("a text"));
    QDragEnterEvent enter({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, {});
    enter.ignore();
    QApplication::sendEvent(&page.window(), &enter);
    EXPECT_FALSE(enter.isAccepted());
}

TEST_F(OpenTest, AFolderIsChosenInTheDialog) {
    const auto folder = drive();
    WindowPage page;
    page.press(Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
    auto* dialog = page.window().findChild<QFileDialog*>();
    ASSERT_NE(dialog, nullptr);
    dialog->setDirectory(QString::fromStdString(folder.parent_path().string()));
    dialog->selectFile(QString::fromStdString(folder.string()));
    QMetaObject::invokeMethod(dialog, "accept");
    page.waitUntilShown();
    EXPECT_EQ(page.scans().model()->rowCount(), 3);
}

TEST_F(OpenTest, RecentSourcesAreOfferedAndOpenAgain) {
    const auto folder = drive();
    WindowPage page;
    page.openAndWait({folder});
    page.action("closeScans").trigger();
    page.waitUntilShown();
    EXPECT_EQ(page.scans().model()->rowCount(), 0);
    EXPECT_TRUE(page.find<QWidget>("help").isVisible());
    const auto entries = page.find<QMenu>("recent").actions();
    ASSERT_FALSE(entries.isEmpty());
    EXPECT_THAT(entries.front()->text().toStdString(), HasSubstr("room"));
    entries.front()->trigger();
    EXPECT_TRUE(eventually([&] { return page.scans().model()->rowCount() == 3; }));
}

TEST_F(OpenTest, CancelEndsTheWorkAndKeepsWhatWasRegistered) {
    // So much that a computer whose window is starved is not done before the key is pressed.
    constexpr int Scans = 14, Rows = 174, Columns = 270;
    const auto folder = m_folder / "large";
    test::writeDrive(folder, Scans, Rows, Columns);
    WindowPage page;
    page.window().open({folder});
    ASSERT_TRUE(eventually([&] { return page.scans().model()->rowCount() >= 1; }));
    ASSERT_TRUE(page.action("cancel").isEnabled());
    page.press(Qt::Key_F5, Qt::ShiftModifier);
    page.waitUntilShown();
    const int kept = page.scans().model()->rowCount();
    EXPECT_GE(kept, 1);
    EXPECT_LT(kept, Scans);
    EXPECT_FALSE(page.action("cancel").isEnabled());
    EXPECT_FALSE(page.find<QWidget>("progress").isVisible());
    page.window().open({folder});
    EXPECT_TRUE(eventually([&] { return page.scans().model()->rowCount() == Scans; }));
}

TEST_F(OpenTest, TheWindowCanCloseInTheMiddleOfItsWork) {
    const auto folder = drive(6);
    auto page = std::make_unique<WindowPage>();
    page->window().open({folder});
    ASSERT_TRUE(eventually([&] { return page->scans().model()->rowCount() >= 1; }));
    page->window().close();
    page.reset();
    EXPECT_TRUE(QApplication::topLevelWidgets().isEmpty());
}

TEST_F(OpenTest, APictureIsSavedInTheDialog) {
    WindowPage page;
    page.openAndWait({drive()});
    const auto file = m_folder / "map.png";
    page.press(Qt::Key_S, Qt::ControlModifier);
    auto* dialog = page.window().findChild<QFileDialog*>();
    ASSERT_NE(dialog, nullptr);
    dialog->selectFile(QString::fromStdString(file.string()));
    QMetaObject::invokeMethod(dialog, "accept");
    const QImage saved(QString::fromStdString(file.string()));
    EXPECT_EQ(saved.size(), page.map().size());
    EXPECT_THAT(page.label("pick"), HasSubstr("map.png"));
}

TEST_F(OpenTest, APictureThatCannotBeWrittenIsAMessage) {
    WindowPage page;
    page.openAndWait({drive()});
    page.press(Qt::Key_S, Qt::ControlModifier);
    auto* dialog = page.window().findChild<QFileDialog*>();
    ASSERT_NE(dialog, nullptr);
    emit dialog->fileSelected(QString::fromStdString((m_folder / "missing" / "map.png").string()));
    EXPECT_EQ(page.find<QListView>("messages").model()->rowCount(), 1);
}

}  // namespace
}  // namespace leitstand
