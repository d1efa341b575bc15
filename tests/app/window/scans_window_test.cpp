#include "app/window/scans/scans_window.h"

#include <vector>

#include <QAction>
#include <QApplication>
#include <QMenuBar>

#include <gtest/gtest.h>

#include "app/language/language.h"
#include "app/window/scans/main_window.h"
#include "tests/app/window/window_page.h"

namespace leitstand::test {
namespace {

class ScansWindowTest : public WindowTest {
protected:
    ~ScansWindowTest() override { useLanguage(QStringLiteral("en")); }
    /// The windows that people see.
    [[nodiscard]] static std::vector<MainWindow*> windows() {
        std::vector<MainWindow*> all;
        for (QWidget* one : QApplication::topLevelWidgets()) {
            auto* window = qobject_cast<MainWindow*>(one);
            if (window != nullptr && window->isVisible()) all.push_back(window);
        }
        return all;
    }
};

TEST_F(ScansWindowTest, AnotherLanguageMakesItAnewWithItsScans) {
    const auto goOn = [] { return windows().size() == 1 && windows().front()->scans().rowCount() == 3; };
    QApplication::setQuitOnLastWindowClosed(false);
    WindowState state;
    state.view.colouring = MapColouring::Height;
    showScansWindow({drive()}, state);
    ASSERT_TRUE(eventually(goOn));
    const QString english = windows().front()->menuBar()->actions().front()->text();
    auto* german = windows().front()->findChild<QAction*>(QStringLiteral("language.de"));
    ASSERT_NE(german, nullptr);
    EXPECT_FALSE(german->isChecked());
    german->trigger();
    ASSERT_TRUE(eventually(goOn));
    MainWindow& again = *windows().front();
    EXPECT_NE(again.menuBar()->actions().front()->text(), english);
    EXPECT_TRUE(again.findChild<QAction*>(QStringLiteral("language.de"))->isChecked());
    EXPECT_EQ(again.mapView().settings().colouring, MapColouring::Height);
    EXPECT_EQ(loadWindowState().language, QStringLiteral("de"));
    again.close();
    EXPECT_TRUE(eventually([] { return windows().empty(); }));
}

}  // namespace
}  // namespace leitstand::test
