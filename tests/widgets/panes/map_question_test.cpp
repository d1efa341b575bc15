#include "widgets/map_decisions/map_question.h"

#include <QAction>
#include <QWidget>

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

struct AskedOverAMap {
    AskedOverAMap() {
        map.resize(900, 700);
        map.show();
    }
    [[nodiscard]] bool apart() const {
        return !first.geometry().intersects(second.geometry()) && map.rect().contains(first.geometry()) &&
               map.rect().contains(second.geometry());
    }

    QWidget map;
    QAction yes{QStringLiteral("Yes")}, no{QStringLiteral("No")};
    MapQuestion first{QStringLiteral("first"), {&yes, &no}, map};
    MapQuestion second{QStringLiteral("second"), {&yes, &no}, map};
};

TEST(MapQuestion, OfTwoNoneLiesOverTheOther) {
    AskedOverAMap asked;
    asked.second.ask(QStringLiteral("Did these two parts see the same place?\nViolet: the map if they did."));
    const QRect alone = asked.second.geometry();
    asked.first.ask(QStringLiteral("Kurt3D from scan 12 on\nOn the rest of the map: 43 %, seam 0.12 m"));
    EXPECT_TRUE(asked.apart());
    asked.second.ask(QStringLiteral("Did they?"));
    EXPECT_TRUE(asked.apart());
    asked.map.resize(500, 420);
    EXPECT_TRUE(asked.apart()) << "over a small map, too";
    asked.map.resize(900, 700);
    EXPECT_TRUE(asked.apart());
    asked.first.ask(QString());
    EXPECT_FALSE(asked.first.isVisible());
    asked.second.ask(QStringLiteral("Did these two parts see the same place?\nViolet: the map if they did."));
    EXPECT_EQ(asked.second.geometry(), alone) << "it comes down";
}

}  // namespace
}  // namespace leitstand::test
