#include "widgets/map_decisions/loop_notice.h"

#include <chrono>
#include <cstdint>
#include <optional>

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
        map.resize(900, 700);
        map.show();
        open.setObjectName(QStringLiteral("loop.undo"));
        notice.emplace(open, map, 0, nullptr);
        follow(0, 0.0, 0);
    }
    void follow(std::uint64_t closed, double largest, int second, bool asked = false) {
        notice->follow(closed, largest, SteadyTime(seconds(1'000 + second)), asked);
    }
    [[nodiscard]] const QFrame& shown() const { return *map.findChild<QFrame*>("loopNotice"); }
    [[nodiscard]] QToolButton& button(const char* name) const { return *map.findChild<QToolButton*>(name); }

    QWidget map;
    QAction open{QStringLiteral("Open loop")};
    std::optional<LoopNotice> notice;
};

TEST(LoopNotice, ALoopThatClosedByItselfIsToldWithTheButtonThatOpensItAgain) {
    NoticeOverAMap reported;
    EXPECT_FALSE(reported.shown().isVisible());
    int opened = 0;
    QObject::connect(&reported.open, &QAction::triggered, [&opened] { ++opened; });
    reported.follow(1, 0.34, 1);
    EXPECT_TRUE(reported.shown().isVisible());
    EXPECT_TRUE(reported.shown().accessibleName().contains("0.34 m"));
    reported.button("button_loop.undo").click();
    EXPECT_EQ(opened, 1);
    EXPECT_FALSE(reported.shown().isVisible());
    reported.follow(1, 0.34, 2);
    EXPECT_FALSE(reported.shown().isVisible()) << "it was answered";
}

TEST(LoopNotice, GoesByItselfAndInterruptsNobodyForLittle) {
    NoticeOverAMap reported;
    reported.follow(1, 0.01, 1);
    EXPECT_FALSE(reported.shown().isVisible()) << "a centimetre";
    reported.follow(2, 0.2, 2);
    reported.follow(2, 0.2, 20);
    EXPECT_TRUE(reported.shown().isVisible());
    reported.follow(3, 0.01, 21);
    EXPECT_FALSE(reported.shown().isVisible()) << "the button would open the newest one";
    reported.follow(4, 0.2, 22);
    reported.follow(4, 0.2, 43);
    EXPECT_FALSE(reported.shown().isVisible());
    reported.follow(5, 0.2, 44);
    reported.button("button_loop.keep").click();
    EXPECT_FALSE(reported.shown().isVisible());
    reported.follow(6, 0.2, 45, true);
    EXPECT_FALSE(reported.shown().isVisible()) << "what the map asks goes before";
}

}  // namespace
}  // namespace leitstand::test
