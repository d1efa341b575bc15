#include <string>
#include <vector>

#include <QDockWidget>
#include <QMenuBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QTableView>

#include <gtest/gtest.h>

#include "app/language/language.h"
#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/layouts/layout_feature.h"
#include "tests/app/cut_texts.h"
#include "tests/app/live/eventful.h"
#include "tests/app/live/live_page.h"
#include "widgets/victims/victim_form.h"

namespace leitstand::test {
namespace {

/// The form of a find, opened from the list while somebody drives.
class FormSheet : public LivePage {
protected:
    FormSheet() : LivePage(Robots::None) {}
    ~FormSheet() override { useLanguage(QStringLiteral("en")); }

    [[nodiscard]] QTableView& finds() const { return *m_window->findChild<QTableView*>("finds"); }
    [[nodiscard]] VictimForm& form() const { return *m_window->findChild<VictimForm*>("formPane"); }
    [[nodiscard]] static QRect inWindow(const QWidget& widget) {
        return {widget.mapTo(widget.window(), QPoint()), widget.size()};
    }
    void openForm() {
        ASSERT_TRUE(soon([&] { return finds().model()->rowCount() >= 5; }));
        finds().selectRow(0);
        m_window->commands().trigger(QStringLiteral("form.next"));  // some layouts have no list
        ASSERT_TRUE(soon([&] { return form().isVisible() && !form().visibleRegion().isEmpty(); }));
        QTest::qWait(50);  // docks are laid out by the event loop
    }
    [[nodiscard]] QDockWidget* dock(const char* pane) const {
        return m_window->panes().findChild<QDockWidget*>(QLatin1String(pane));
    }
    /// Panes that tell the driver something, as far as the layout shows them.
    [[nodiscard]] std::vector<QDockWidget*> instruments() const {
        std::vector<QDockWidget*> shown;
        for (const char* pane : {"camera", "right", "scan", "strip", "alarms"})
            if (dock(pane)->isVisible()) shown.push_back(dock(pane));
        return shown;
    }
    /// What of @p instruments and of the bars above the form covers; empty: nothing.
    [[nodiscard]] std::string covered(const std::vector<QDockWidget*>& instruments) const {
        std::string names;
        const QRect sheet = inWindow(form());
        for (const QDockWidget* one : instruments) {
            const bool seen = one->isVisible() && !one->visibleRegion().isEmpty();
            if (!seen || inWindow(*one).intersects(sheet)) names += one->objectName().toStdString() + " ";
        }
        for (const char* name : {"topBar", "stop"}) {
            if (inWindow(*m_window->findChild<QWidget*>(QLatin1String(name))).intersects(sheet))
                names += name;
        }
        return inWindow(*m_window->menuBar()).intersects(sheet) ? names + "menus" : names;
    }
};

TEST_F(FormSheet, IsWideAndCoversNoInstrumentInAnyLayoutSizeAndLanguage) {
    ASSERT_TRUE(makeEventful(station(), [](auto holds) { return soon(holds); }));
    for (const char* language : {"en", "de", "ja"}) {
        useLanguage(QLatin1String(language));
        restart();
        for (const QSize size : {QSize(1024, 768), QSize(1280, 800), QSize(1920, 1080)}) {
            m_window->resize(size);
            for (const char* layout : {"drive", "explore", "map", "link", "review", "report"}) {
                SCOPED_TRACE(std::string(language) + ", " + layout + ", " + std::to_string(size.width()));
                ASSERT_TRUE(m_window->layouts().use(QLatin1String(layout)));
                QTest::qWait(20);
                const auto shown = instruments();
                ASSERT_NO_FATAL_FAILURE(openForm());
                EXPECT_GE(form().width(), 420);
                EXPECT_EQ(covered(shown), "");
                EXPECT_EQ(cutTexts(form()).join(QStringLiteral("; ")).toStdString(), "");
                EXPECT_EQ(m_window->size(), size);
                const QString folder = qEnvironmentVariable("LEITSTAND_PICTURES");
                if (!folder.isEmpty())
                    m_window->grab().save(QStringLiteral("%1/sheet_%2_%3_%4.png")
                                              .arg(folder, QLatin1String(layout), QLatin1String(language))
                                              .arg(size.width()));
            }
        }
    }
}

TEST_F(FormSheet, IsWholeInTheLayoutOfTheReport) {
    ASSERT_TRUE(makeEventful(station(), [](auto holds) { return soon(holds); }));
    for (const char* language : {"en", "de", "ja"}) {
        useLanguage(QLatin1String(language));
        restart();
        for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
            SCOPED_TRACE(std::string(language) + ", " + std::to_string(size.width()));
            m_window->resize(size);
            ASSERT_TRUE(m_window->layouts().use(QStringLiteral("report")));
            ASSERT_NO_FATAL_FAILURE(openForm());
            auto* const area = form().findChild<QScrollArea*>();
            EXPECT_TRUE(soon([&] { return area->verticalScrollBar()->maximum() == 0; }))
                << area->verticalScrollBar()->maximum() << " px of it are out of sight";
        }
    }
}

}  // namespace
}  // namespace leitstand::test
