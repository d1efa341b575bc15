#include <map>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QKeySequence>
#include <QLabel>
#include <QTabBar>

#include <gtest/gtest.h>

#include "app/language/language.h"
#include "app/window/commands/command_table.h"
#include "app/window/live/layouts/layout_feature.h"
#include "app/window/live/pane_docks.h"
#include "tests/app/cut_texts.h"
#include "tests/app/live/live_page.h"
#include "tests/app/window_size.h"
#include "widgets/map_view/map_view.h"
#include "widgets/mission/mission_form.h"
#include "widgets/pad/pad_mapping_dialog.h"

namespace leitstand::test {
namespace {

/// The window in every language and layout.
class LiveTexts : public LivePage {
protected:
    ~LiveTexts() override { useLanguage(QStringLiteral("en")); }
};

TEST_F(LiveTexts, FitInEveryLayoutAndLanguage) {
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    {
        QLabel narrow(QStringLiteral("far too long"), m_window.get());
        narrow.setGeometry(0, 0, 20, 20);
        narrow.show();
        ASSERT_EQ(cutTexts(*m_window).size(), 1) << "what is cut is seen";
    }
    for (const char* language : {"en", "de", "ja"}) {
        useLanguage(QLatin1String(language));
        restart();
        ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
        ASSERT_EQ(m_window->size(), windowSize());
        ASSERT_EQ(m_window->devicePixelRatioF(), windowScale());
        for (const char* layout : {"drive", "explore", "map", "review", "link", "report"}) {
            m_window->layouts().use(QLatin1String(layout));
            EXPECT_TRUE(soon([&] { return m_window->mapView().settled(); }));
            EXPECT_EQ(cutTexts(*m_window).join(QStringLiteral("; ")).toStdString(), "")
                << language << ", " << layout;
            EXPECT_EQ(m_window->size(), windowSize()) << language << ", " << layout;
            lookAt(QStringLiteral("texts_%1_%2").arg(QLatin1String(layout), QLatin1String(language)));
        }
    }
}

TEST_F(LiveTexts, ATabThatIsCutIsSeen) {
    QTabBar tabs(m_window.get());
    tabs.addTab(QStringLiteral("far too long a name"));
    tabs.setElideMode(Qt::ElideRight);
    tabs.setUsesScrollButtons(false);
    tabs.show();
    tabs.resize(tabs.sizeHint());
    const auto whole = cutTexts(*m_window).filter(QStringLiteral("far too long"));
    EXPECT_TRUE(whole.isEmpty()) << whole.join("; ").toStdString();
    tabs.resize(40, tabs.height());
    EXPECT_EQ(cutTexts(*m_window).filter(QStringLiteral("far too long")).size(), 1);
}

TEST_F(LiveTexts, FitInDialogsAndTabsInEveryLanguage) {
    for (const char* language : {"en", "de", "ja"}) {
        useLanguage(QLatin1String(language));
        restart();
        const auto expectWhole = [&](const QWidget* dialog, const char* what) {
            ASSERT_NE(dialog, nullptr) << what;
            ASSERT_TRUE(soon([&] { return dialog->isVisible(); })) << what;
            EXPECT_EQ(cutTexts(*dialog).join(QStringLiteral("; ")).toStdString(), "")
                << language << ", " << what;
        };
        m_window->commands().trigger("pad.controls");
        expectWhole(m_window->findChild<PadMappingDialog*>(), "gamepad");
        m_window->commands().trigger("mission.data");
        expectWhole(m_window->findChild<MissionForm*>("missionForm"), "mission data");
        auto* const keys = m_window->findChild<QAction*>("keys");
        ASSERT_NE(keys, nullptr);
        keys->trigger();
        auto* const dialog = m_window->findChild<QDialog*>("keysDialog");
        expectWhole(dialog, "keys");
        if (dialog != nullptr) dialog->close();
        // In layout Drive these open as tabs.
        m_window->layouts().use("drive");
        for (const char* pane : {"form", "score", "missed"}) m_window->panes().open(QLatin1String(pane));
        QTest::qWait(200);  // tabs are laid out by the event loop
        EXPECT_EQ(cutTexts(*m_window).filter(QStringLiteral("TabBar")).join("; ").toStdString(), "")
            << language;
    }
}

TEST_F(LiveTexts, EveryKeyMeansOneThing) {
    std::map<QString, QStringList> meanings;
    for (const QAction* action : m_window->findChildren<QAction*>()) {
        for (const QKeySequence& keys : action->shortcuts()) meanings[keys.toString()] += action->text();
    }
    EXPECT_GT(meanings.size(), 40U);
    for (const auto& [keys, what] : meanings)
        EXPECT_EQ(what.size(), 1) << keys.toStdString() << ": " << what.join(", ").toStdString();
    // Nor do driving, cameras or STOP, which take keys before shortcuts do.
    for (const auto& [keys, what] : meanings) {
        const QKeyCombination pressed = QKeySequence(keys)[0];
        QKeyEvent asked(QEvent::ShortcutOverride, pressed.key(), pressed.keyboardModifiers());
        asked.ignore();
        QApplication::sendEvent(m_window->centralWidget(), &asked);
        EXPECT_FALSE(asked.isAccepted()) << keys.toStdString() << ": " << what.join(", ").toStdString();
    }
    QKeyEvent turns(QEvent::ShortcutOverride, Qt::Key_Q, Qt::ShiftModifier);
    turns.ignore();
    QApplication::sendEvent(m_window->centralWidget(), &turns);
    EXPECT_TRUE(turns.isAccepted()) << "who takes a key is seen";
}

}  // namespace
}  // namespace leitstand::test
