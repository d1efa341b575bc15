#include <set>

#include <gmock/gmock.h>
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QHeaderView>
#include <QLabel>
#include <QSettings>
#include <QTableView>
#include <QToolButton>

#include "tests/app/window/window_page.h"
#include "widgets/scans/scans_panel.h"

namespace leitstand {
namespace {

using test::WindowPage;
using test::WindowTest;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::SizeIs;

class WholeWindowTest : public WindowTest {};

TEST_F(WholeWindowTest, EverythingIsReachedByTab) {
    WindowPage page;
    page.openAndWait({drive()});
    page.map().setFocus();
    std::set<std::string> reached;
    for (int step = 0; step < 60; ++step) {
        page.press(Qt::Key_Tab);
        if (const QWidget* focus = QApplication::focusWidget())
            reached.insert(focus->objectName().toStdString());
    }
    EXPECT_THAT(reached, IsSupersetOf({"map", "tool_lookPoints", "tool_measure", "scans", "minimizer",
                                       "search", "distances", "reduce", "minRange", "maxRange", "reference",
                                       "registerAgain", "before", "defaults", "messageCount"}));
}

TEST_F(WholeWindowTest, ScansAreTickedByKeyboard) {
    WindowPage page;
    page.openAndWait({drive()});
    page.scans().setFocus();
    page.scans().setCurrentIndex(page.scans().model()->index(0, ScanListModel::Name));
    page.press(Qt::Key_Down);
    page.press(Qt::Key_Space);
    EXPECT_THAT(page.window().scans().visible(), ElementsAre(true, false, true));
}

TEST_F(WholeWindowTest, NoCommandSitsOnADrivingKeyAndNoKeyIsUsedTwice) {
    WindowPage page;
    std::set<QString> seen;
    for (const QAction* action : page.window().findChildren<QAction*>()) {
        if (action->shortcutContext() != Qt::WindowShortcut || action->shortcut().isEmpty()) continue;
        const QString keys = action->shortcut().toString();
        for (const char* driving : {"W", "A", "S", "D", "Space", "Backspace"}) {
            EXPECT_NE(keys, QLatin1String(driving)) << action->text().toStdString();
        }
        EXPECT_TRUE(seen.insert(keys).second) << keys.toStdString() << " is used twice";
    }
    EXPECT_GT(seen.size(), 15u);
}

TEST_F(WholeWindowTest, TheKeysDialogListsTheKeysOfTheCommands) {
    WindowPage page;
    page.press(Qt::Key_F1);
    const auto* dialog = page.window().findChild<QDialog*>(QStringLiteral("keysDialog"));
    ASSERT_NE(dialog, nullptr);
    std::set<std::string> texts;
    for (const QLabel* label : dialog->findChildren<QLabel*>()) texts.insert(label->text().toStdString());
    EXPECT_THAT(texts,
                IsSupersetOf({"Ctrl+O", "Open scans…", "F5", "Register again", "Ctrl+Shift+M", "Measure"}));
}

/// Captions whose text needs more room than they have.
std::vector<std::string> clippedTexts(const QWidget& window) {
    std::vector<std::string> clipped;
    for (const QLabel* label : window.findChildren<QLabel*>()) {
        const bool wraps = label->wordWrap();
        if (!label->isVisible() || label->text().isEmpty()) continue;
        if (!wraps && label->width() < label->sizeHint().width())
            clipped.push_back(label->text().toStdString());
        if (wraps && label->height() < label->heightForWidth(label->width())) {
            clipped.push_back(label->text().toStdString());
        }
    }
    for (const QToolButton* button : window.findChildren<QToolButton*>()) {
        const bool hasText = button->toolButtonStyle() != Qt::ToolButtonIconOnly || button->icon().isNull();
        if (button->isVisible() && hasText && button->width() < button->sizeHint().width()) {
            clipped.push_back(button->text().toStdString());
        }
    }
    return clipped;
}

TEST_F(WholeWindowTest, NothingIsClippedInSmallAndLargeWindows) {
    WindowPage page;
    page.openAndWait({drive()});
    for (const QSize size : {QSize(1024, 700), QSize(1280, 800), QSize(1920, 1080)}) {
        page.window().resize(size);
        QApplication::processEvents();
        EXPECT_THAT(clippedTexts(page.window()), IsEmpty()) << size.width();
        const QTableView& table = page.scans();
        for (int column = 0; column < ScanListModel::ColumnCount; ++column) {
            if (table.isColumnHidden(column)) continue;
            for (int row = 0; row < table.model()->rowCount(); ++row) {
                const QString text = table.model()->index(row, column).data().toString();
                EXPECT_GE(table.columnWidth(column), table.fontMetrics().horizontalAdvance(text) + 12)
                    << text.toStdString();
            }
        }
        EXPECT_LE(table.horizontalHeader()->length(), table.viewport()->width());
    }
}

TEST_F(WholeWindowTest, ColumnsGiveWayInANarrowTableAndComeBackInAWideOne) {
    WindowPage page;
    page.openAndWait({drive()});
    ScanListModel scans;
    scans.setMap(page.window().scans().map());
    ScansPanel panel(scans);
    panel.resize(320, 400);
    panel.show();
    const auto& table = *panel.findChild<QTableView*>(QStringLiteral("scans"));
    EXPECT_TRUE(table.isColumnHidden(ScanListModel::Ceiling));
    EXPECT_TRUE(table.isColumnHidden(ScanListModel::Position));
    EXPECT_FALSE(table.isColumnHidden(ScanListModel::Overlap));
    EXPECT_FALSE(table.isColumnHidden(ScanListModel::Certainty));
    panel.resize(1000, 400);
    for (int column = 0; column < ScanListModel::ColumnCount; ++column) {
        EXPECT_FALSE(table.isColumnHidden(column)) << column;
    }
}

TEST_F(WholeWindowTest, WhatWasSetIsThereAtTheNextStart) {
    {
        WindowPage page;
        page.openAndWait({drive()});
        page.press(Qt::Key_2);
        page.press(Qt::Key_3, Qt::ControlModifier);
        page.action("themeLight").trigger();
        WindowState state = page.window().state();
        state.registration.minimizer = Minimizer::DualQuaternion;
        state.registration.maxDistances = {1.5, 0.5};
        state.registration.threads = 2;
        saveWindowState(state);
    }
    const WindowState state = loadWindowState();
    EXPECT_EQ(state.view.look, MapLook::Voxels);
    EXPECT_EQ(state.view.colouring, MapColouring::Height);
    EXPECT_EQ(state.view.theme, Theme::Light);
    EXPECT_EQ(state.registration.minimizer, Minimizer::DualQuaternion);
    EXPECT_THAT(state.registration.maxDistances, ElementsAre(1.5, 0.5));
    EXPECT_EQ(state.registration.threads, 2);
    EXPECT_THAT(state.recent, ElementsAre(ElementsAre(m_folder / "room")));
    WindowPage page(state);
    EXPECT_EQ(page.map().settings().look, MapLook::Voxels);
    EXPECT_TRUE(page.action("themeLight").isChecked());
}

TEST_F(WholeWindowTest, ARememberedStateThatMakesNoSenseIsLeftOut) {
    {
        QSettings file(QSettings::IniFormat, QSettings::UserScope, QStringLiteral("leitstand"),
                       QStringLiteral("leitstand"));
        file.setValue(QStringLiteral("view/look"), 99);
        file.setValue(QStringLiteral("view/voxel"), QStringLiteral("huge"));
        file.setValue(QStringLiteral("registration/minimizer"), QStringLiteral("magic"));
        file.setValue(QStringLiteral("registration/distances"), QStringLiteral("5, 6"));
        file.setValue(QStringLiteral("registration/iterations"), -3);
        file.setValue(QStringLiteral("registration/minRange"), 9);
        file.setValue(QStringLiteral("registration/maxRange"), 2);
    }
    const WindowState state = loadWindowState();
    const RegistrationSettings defaults;
    EXPECT_EQ(state.view.look, MapLook::Points);
    EXPECT_DOUBLE_EQ(state.view.voxelSize, 0.1);
    EXPECT_EQ(state.registration.minimizer, defaults.minimizer);
    EXPECT_EQ(state.registration.maxDistances, defaults.maxDistances);
    EXPECT_EQ(state.registration.maxIterations, defaults.maxIterations);
    EXPECT_DOUBLE_EQ(state.registration.minRange, defaults.minRange);
    EXPECT_DOUBLE_EQ(state.registration.maxRange, defaults.maxRange);
}

TEST_F(WholeWindowTest, TheNewestSourcesAreRememberedWithoutRepetition) {
    std::vector<Sources> recent;
    for (int i = 0; i < 12; ++i) remember(recent, {"/scans/" + std::to_string(i)});
    remember(recent, {"/scans/7"});
    ASSERT_THAT(recent, SizeIs(8));
    EXPECT_THAT(recent[0], ElementsAre("/scans/7"));
    EXPECT_THAT(recent[1], ElementsAre("/scans/11"));
}

}  // namespace
}  // namespace leitstand
