#include <map>

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QKeySequence>
#include <QLabel>

#include <gtest/gtest.h>

#include "app/language/language.h"
#include "app/window/live/layouts/layout_feature.h"
#include "tests/app/cut_texts.h"
#include "tests/app/live/live_page.h"
#include "widgets/map_view/map_view.h"

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
        for (const char* layout : {"drive", "explore", "map", "review", "link", "report"}) {
            m_window->layouts().use(QLatin1String(layout));
            EXPECT_TRUE(soon([&] { return m_window->mapView().settled(); }));
            EXPECT_EQ(cutTexts(*m_window).join(QStringLiteral("; ")).toStdString(), "")
                << language << ", " << layout;
            lookAt(QStringLiteral("texts_%1_%2").arg(QLatin1String(layout), QLatin1String(language)));
        }
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
