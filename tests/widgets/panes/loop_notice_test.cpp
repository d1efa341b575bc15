#include "widgets/map_decisions/loop_notice.h"

#include <chrono>

#include <QAction>
#include <QFrame>
#include <QToolButton>
#include <QWidget>

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

using std::chrono::seconds;

struct NoticeOverAMap {
    NoticeOverAMap() {
        open.setObjectName(QStringLiteral("loop.undo"));
        map.resize(900, 700);
        map.show();
        notice.follow(0, 0.0, at(0), false);
    }
    static SteadyTime at(int second) { return SteadyTime(seconds(1'000 + second)); }
    [[nodiscard]] const QFrame& shown() const { return *map.findChild<QFrame*>("loopNotice"); }
    [[nodiscard]] QToolButton& button(const char* name) const { return *map.findChild<QToolButton*>(name); }

    QWidget map;
    QAction open{QStringLiteral("Open loop")};
    LoopNotice notice{open, map, nullptr};
};

TEST(LoopNotice, ALoopThatClosedByItselfIsToldWithTheButtonThatOpensItAgain) {
    NoticeOverAMap told;
    EXPECT_FALSE(told.shown().isVisible());
    int opened = 0;
    QObject::connect(&told.open, &QAction::triggered, [&opened] { ++opened; });
    told.notice.follow(1, 0.34, NoticeOverAMap::at(1), false);
    EXPECT_TRUE(told.shown().isVisible());
    EXPECT_TRUE(told.shown().accessibleName().contains("0.34 m"));
    told.button("button_loop.undo").click();
    EXPECT_EQ(opened, 1);
    EXPECT_FALSE(told.shown().isVisible());
    told.notice.follow(1, 0.34, NoticeOverAMap::at(2), false);
    EXPECT_FALSE(told.shown().isVisible()) << "it was answered";
}

TEST(LoopNotice, GoesByItselfAndInterruptsNobodyForLittle) {
    NoticeOverAMap told;
    told.notice.follow(1, 0.01, NoticeOverAMap::at(1), false);
    EXPECT_FALSE(told.shown().isVisible()) << "a centimetre";
    told.notice.follow(2, 0.2, NoticeOverAMap::at(2), false);
    told.notice.follow(2, 0.2, NoticeOverAMap::at(20), false);
    EXPECT_TRUE(told.shown().isVisible());
    told.notice.follow(2, 0.2, NoticeOverAMap::at(23), false);
    EXPECT_FALSE(told.shown().isVisible());
    told.notice.follow(3, 0.2, NoticeOverAMap::at(24), false);
    told.button("button_loop.keep").click();
    EXPECT_FALSE(told.shown().isVisible());
    told.notice.follow(4, 0.2, NoticeOverAMap::at(25), true);
    EXPECT_FALSE(told.shown().isVisible()) << "what the map asks goes before";
}

}  // namespace
}  // namespace leitstand::test
