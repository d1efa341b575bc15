#include "tests/app/window/review_page.h"

#include <set>

#include <gmock/gmock.h>
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QLabel>

#include "app/window/commands/command_table.h"
#include "app/window/layouts/layout_feature.h"
#include "tests/app/reach.h"

namespace leitstand::test {
namespace {

using testing::Contains;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;
using ReviewKeys = ReviewPage;

TEST_F(ReviewKeys, TheListOfKeysIsNoModalBoxAndIsTheReviewsOwn) {
    m_window->commands().trigger(QStringLiteral("keys"));
    const auto& dialog = find<QDialog>("keysDialog");
    EXPECT_TRUE(dialog.isVisible());
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    std::set<std::string> texts;
    for (const QLabel* label : dialog.findChildren<QLabel*>()) texts.insert(label->text().toStdString());
    EXPECT_THAT(texts, IsSupersetOf({"F1", "Space", "Play", "Home, End", "ends measuring"}));
    EXPECT_THAT(texts, Not(Contains("in the scans list: shows or hides the scan")));
    m_window->commands().trigger(QStringLiteral("about"));
    EXPECT_TRUE(find<QDialog>("aboutBox").isVisible());
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
}

TEST_F(ReviewKeys, EverythingInEveryLayoutHasANameAndIsReachedByKeys) {
    goTo(47.0);
    for (const char* layout : {"drive", "explore", "map", "review", "report", "compare"}) {
        ASSERT_TRUE(m_window->layouts().use(QLatin1String(layout)));
        QApplication::processEvents();
        EXPECT_GT(thingsToUse(*m_window), 10) << layout;
        EXPECT_THAT(outOfReach(*m_window), IsEmpty()) << layout;
    }
}

}  // namespace
}  // namespace leitstand::test
