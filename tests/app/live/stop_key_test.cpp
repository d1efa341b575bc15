#include "app/window/input/stop_key.h"

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QSignalSpy>
#include <QWindow>

#include <gtest/gtest.h>

#include "app/window/frame/pane_docks.h"
#include "tests/app/live/quiet_page.h"
#include "widgets/preflight/preflight_page.h"

namespace leitstand::test {
namespace {

/// Esc, as the desktop hands it to the window that has the keyboard.
class EscStops : public QuietPage {
protected:
    EscStops() : m_stops(window().findChild<StopKey*>(), &StopKey::pressed) {}
    /// How often one press of Esc in @p where stops.
    [[nodiscard]] qsizetype pressIn(QWidget& where) {
        const qsizetype before = m_stops.size();
        QTest::keyClick(where.window()->windowHandle(), Qt::Key_Escape);
        return m_stops.size() - before;
    }
    template <class T>
    [[nodiscard]] T& opened(const char* name) {
        T* const found = window().findChild<T*>(QLatin1String(name));
        if (found == nullptr) throw std::runtime_error(std::string("there is no ") + name);
        EXPECT_TRUE(QTest::qWaitForWindowActive(found->window()));
        return *found;
    }

    QSignalSpy m_stops;
};

TEST_F(EscStops, WhileAMenuIsOpen) {
    auto* const menu = window().menuBar()->findChild<QMenu*>();
    ASSERT_NE(menu, nullptr);
    menu->popup(window().mapToGlobal(QPoint(20, 20)));
    ASSERT_TRUE(soon([&] { return QApplication::activePopupWidget() == menu; }));
    EXPECT_EQ(pressIn(window()), 1);
    for (const char* robot : {"kurt3d", "crawler"})
        EXPECT_TRUE(soon([&] { return station().robot(robot).stop.sent; })) << robot;
    EXPECT_EQ(pressIn(*menu), 1) << "and again";
    menu->close();
}

TEST_F(EscStops, WhileTextIsTypedInADialogWhichStaysOpen) {
    command("layout.save").trigger();
    auto* const question = window().findChild<QInputDialog*>();
    ASSERT_NE(question, nullptr);
    ASSERT_TRUE(QTest::qWaitForWindowActive(question));
    auto* const line = question->findChild<QLineEdit*>();
    ASSERT_NE(line, nullptr);
    line->setFocus();
    EXPECT_EQ(pressIn(*line), 1);
    EXPECT_TRUE(question->isVisible());
    question->close();
}

TEST_F(EscStops, WhileAFieldOfAPaneHasTheKeyboard) {
    window().panes().open(QStringLiteral("link"));
    auto* const budget = window().findChild<QWidget*>(QStringLiteral("budget"));
    ASSERT_NE(budget, nullptr);
    budget->setFocus();
    ASSERT_TRUE(soon([&] { return budget->hasFocus(); }));
    EXPECT_EQ(pressIn(*budget), 1);
}

TEST_F(EscStops, WhileAListOfChoicesIsDroppedDown) {
    command("mission.data").trigger();
    auto& form = opened<QDialog>("missionForm");
    auto* const box = form.findChild<QComboBox*>();
    ASSERT_NE(box, nullptr);
    box->showPopup();
    ASSERT_TRUE(soon([] { return QApplication::activePopupWidget() != nullptr; }));
    EXPECT_EQ(pressIn(form), 1);
    EXPECT_TRUE(form.isVisible());
    box->hidePopup();
}

TEST_F(EscStops, InTheListOfKeysAndOnThePreflightPage) {
    command("keys").trigger();
    auto& keys = opened<QDialog>("keysDialog");
    EXPECT_EQ(pressIn(keys), 1);
    EXPECT_TRUE(keys.isVisible()) << "Esc closes nothing here";
    keys.close();
    command("preflight.open").trigger();
    auto& page = opened<PreflightPage>("preflight");
    EXPECT_EQ(pressIn(page), 1);
    EXPECT_TRUE(page.isVisible());
}

TEST_F(EscStops, InAPaneThatFloats) {
    auto* const dock = window().panes().findChild<QDockWidget*>(QStringLiteral("alarms"));
    ASSERT_NE(dock, nullptr);
    dock->setFloating(true);
    dock->show();
    dock->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(dock));
    EXPECT_EQ(pressIn(*dock), 1);
    EXPECT_TRUE(dock->isVisible());
}

TEST_F(EscStops, WhoHoldsItDownStopsOnce) {
    QTest::keyPress(&window(), Qt::Key_Escape);
    QKeyEvent again(QEvent::KeyPress, Qt::Key_Escape, {}, {}, /*autorep=*/true);
    QApplication::sendEvent(&window(), &again);
    EXPECT_EQ(m_stops.size(), 1);
    QTest::keyRelease(&window(), Qt::Key_Escape);
    EXPECT_EQ(m_stops.size(), 1);
}

}  // namespace
}  // namespace leitstand::test
