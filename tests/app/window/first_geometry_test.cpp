#include "app/window/shell/first_geometry.h"

#include <gtest/gtest.h>
#include <QScreen>
#include <QTest>
#include <QWidget>

namespace leitstand::test {
namespace {

constexpr QMargins Frame(4, 30, 4, 4);
constexpr QSize Usual(1280, 800);

TEST(FirstGeometry, FitsWithItsFrameWhereTheScreenIsSmall) {
    for (const QRect& screen : {QRect(0, 0, 1280, 800), QRect(0, 0, 1024, 768), QRect(0, 27, 1280, 773)}) {
        const FirstGeometry first = firstGeometry(screen, Frame, Usual);
        EXPECT_TRUE(screen.contains(first.inside.marginsAdded(Frame))) << screen.width();
        EXPECT_FALSE(first.maximised) << "it has all of it already";
        EXPECT_EQ(first.inside.marginsAdded(Frame).width(), screen.width());
    }
}

TEST(FirstGeometry, IsMaximisedWhereMoreFits) {
    const QRect screen(1280, 0, 1920, 1080);  // the right one of two
    const FirstGeometry first = firstGeometry(screen, Frame, Usual);
    EXPECT_TRUE(first.maximised);
    EXPECT_EQ(first.inside.size(), Usual) << "as soon as it is not maximised any more";
    EXPECT_TRUE(screen.contains(first.inside.marginsAdded(Frame)));
}

TEST(FirstGeometry, AHigherScreenThatIsNoWiderIsUsedToItsEnd) {
    const FirstGeometry first = firstGeometry(QRect(0, 0, 1280, 1024), Frame, Usual);
    EXPECT_EQ(first.inside.width(), 1280 - 8);
    EXPECT_TRUE(first.maximised);
}

TEST(FirstGeometry, AWindowIsShownSo) {
    QWidget window;
    const QRect screen = window.screen()->availableGeometry();
    showAsLeft(window, {}, screen.size());  // as large as the screen, without its frame
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    EXPECT_TRUE(screen.contains(window.frameGeometry()));
    EXPECT_FALSE(window.isMaximized());

    QWidget small;
    showAsLeft(small, {}, screen.size() / 2);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&small));
    EXPECT_TRUE(small.isMaximized());

    QWidget left;
    left.setGeometry(40, 60, 300, 200);
    QWidget again;
    showAsLeft(again, left.saveGeometry(), screen.size() / 2);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&again));
    EXPECT_EQ(again.size(), QSize(300, 200)) << "as it was left";
    EXPECT_FALSE(again.isMaximized());
}

}  // namespace
}  // namespace leitstand::test
