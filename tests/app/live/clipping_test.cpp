#include <map>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QKeyEvent>
#include <QKeySequence>
#include <QLabel>
#include <QListView>
#include <QRegularExpression>
#include <QTabBar>
#include <QTableView>
#include <QTableWidget>

#include <gtest/gtest.h>

#include "app/language/language.h"
#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/layouts/layout_feature.h"
#include "core/event/find_sample.h"
#include "core/mission/state/find_state.h"
#include "tests/app/cut_texts.h"
#include "tests/app/live/eventful.h"
#include "tests/app/live/live_page.h"
#include "tests/app/window_size.h"
#include "tests/widgets/panes/shown.h"
#include "widgets/map_view/map_view.h"
#include "widgets/mission/mission_form.h"
#include "widgets/pad/pad_mapping_dialog.h"
#include "widgets/robots/robot_chip_button.h"

namespace leitstand::test {
namespace {

/// The window in every language and layout.
class LiveTexts : public LivePage {
protected:
    ~LiveTexts() override { useLanguage(QStringLiteral("en")); }
    /// What stands in the bar of a robot that is connected, when figures are left out that are not zero;
    /// empty: all have theirs.
    [[nodiscard]] std::string withoutFigures() const {
        static const QRegularExpression figure(QStringLiteral("[0-9.,]+"));
        for (RobotChipButton* chip : m_window->findChildren<RobotChipButton*>()) {
            if (chip->chip().link != LinkState::Connected) continue;
            QString shown;
            for (const PaintedText& one : paintedTexts(*chip)) shown += one.text + QLatin1Char(' ');
            auto figures = figure.globalMatch(chip->chip().figures.value(0));
            while (figures.hasNext()) {
                const QString one = figures.next().captured();
                if (one != QStringLiteral("0") && !shown.contains(one)) return shown.toStdString();
            }
        }
        return {};
    }
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
        EXPECT_TRUE(soon([&] { return withoutFigures().empty(); })) << language << ": " << withoutFigures();
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

/// What lists show when much has happened: alarms, finds, a form that is filled in.
class EventfulTexts : public LivePage {
protected:
    EventfulTexts() : LivePage(Robots::None) {}
    ~EventfulTexts() override { useLanguage(QStringLiteral("en")); }
    void fillForm() {
        FindSample form = station().mission()->finds->at({FindSample::Kind::Victim, 1}).victim;
        const VictimSign present{VictimSign::State::Present, "", Unknown};
        form.form = form.motion = form.sound = present;
        form.heat = {VictimSign::State::Present, "face", 34.0};
        form.co2 = {VictimSign::State::Present, "rising", 2'400.0};
        form.situation = "entombed";
        form.area = "yellow";
        form.tag = "R-17";
        ASSERT_TRUE(station().finds().edit(form).ok());
        ASSERT_TRUE(station().finds().confirm({FindSample::Kind::Victim, 1}).ok());
    }
    template <class View>
    [[nodiscard]] int rowsOf(const char* name) const {
        return m_window->findChild<View*>(QLatin1String(name))->model()->rowCount();
    }
};

TEST_F(EventfulTexts, FitInEveryLayoutAndLanguage) {
    ASSERT_TRUE(makeEventful(station(), [](auto holds) { return soon(holds); }));
    ASSERT_NO_FATAL_FAILURE(fillForm());
    for (const char* language : {"en", "de", "ja"}) {
        useLanguage(QLatin1String(language));
        restart();
        station().stopAll();
        ASSERT_TRUE(
            soon([&] { return rowsOf<QListView>("alarms") >= 2 && rowsOf<QTableView>("finds") >= 5; }));
        m_window->findChild<QTableView*>("finds")->selectRow(0);
        for (const char* layout : {"drive", "explore", "map", "review", "link", "report"}) {
            m_window->layouts().use(QLatin1String(layout));
            EXPECT_TRUE(soon([&] { return m_window->mapView().settled(); }));
            EXPECT_EQ(cutTexts(*m_window).join(QStringLiteral("; ")).toStdString(), "")
                << language << ", " << layout;
            EXPECT_EQ(m_window->size(), windowSize()) << language << ", " << layout;
            const QString folder = qEnvironmentVariable("LEITSTAND_PICTURES");
            if (!folder.isEmpty())
                m_window->grab().save(QStringLiteral("%1/eventful_%2_%3.png")
                                          .arg(folder, QLatin1String(layout), QLatin1String(language)));
        }
    }
}

TEST_F(LiveTexts, ACellThatIsCutIsSeen) {
    QTableWidget table(1, 1, m_window.get());
    table.setItem(0, 0, new QTableWidgetItem(QStringLiteral("far too long for its cell")));
    table.show();
    table.setColumnWidth(0, 400);
    table.resize(500, 100);
    EXPECT_TRUE(cutTexts(*m_window).filter(QStringLiteral("far")).isEmpty());
    table.setColumnWidth(0, 60);
    EXPECT_EQ(cutTexts(*m_window).filter(QStringLiteral("far")).size(), 1);
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
