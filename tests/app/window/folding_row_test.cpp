#include "app/window/frame/folding_row.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QWidget>

namespace leitstand {
namespace {

using testing::ElementsAre;

const std::vector<PartWidths> Bar = {
    {.least = 100, .liked = 300, .most = 500, .gives = GivesWay::LittleByLittle},
    {.least = 80, .liked = 200, .most = 200, .gives = GivesWay::AtOnce},
    {.least = 90, .liked = 90, .most = 90}};

TEST(FoldedWidths, AreAsLikedAndWhatIsLeftOverGoesToThePartThatStretches) {
    EXPECT_THAT(foldedWidths(Bar, 590), ElementsAre(300, 200, 90));
    EXPECT_THAT(foldedWidths(Bar, 700), ElementsAre(410, 200, 90));
    EXPECT_THAT(foldedWidths(Bar, 2000), ElementsAre(500, 200, 90)) << "and no more than it may";
}

TEST(FoldedWidths, FoldAtOnceBeforeOthersGiveWayLittleByLittle) {
    EXPECT_THAT(foldedWidths(Bar, 589), ElementsAre(419, 80, 90)) << "what that frees is used";
    EXPECT_THAT(foldedWidths(Bar, 470), ElementsAre(300, 80, 90));
    EXPECT_THAT(foldedWidths(Bar, 400), ElementsAre(230, 80, 90));
    EXPECT_THAT(foldedWidths(Bar, 270), ElementsAre(100, 80, 90));
    EXPECT_THAT(foldedWidths(Bar, 0), ElementsAre(100, 80, 90)) << "never below the least";
}

/// A part of sizes that are set.
class Part final : public QWidget {
public:
    Part(int least, int liked, QWidget* parent) : QWidget(parent), m_least(least), m_liked(liked) {}
    [[nodiscard]] QSize minimumSizeHint() const override { return {m_least, 20}; }
    [[nodiscard]] QSize sizeHint() const override { return {m_liked, 30}; }

private:
    int m_least, m_liked;
};

TEST(FoldingRows, KeepTheRightOnesInTheCornerAndNeverGetNarrowerThanTheirParts) {
    QWidget window;
    auto* row = new FoldingRow(&window);
    row->setContentsMargins(8, 6, 8, 6);
    row->setSpacing(10);
    auto* robots = new Part(100, 300, &window);
    robots->setMaximumWidth(500);
    auto* tabs = new Part(80, 200, &window);
    auto* stop = new Part(90, 90, &window);
    row->add(*robots, GivesWay::LittleByLittle);
    row->add(*tabs, GivesWay::AtOnce);
    row->add(*stop, GivesWay::Never, true);
    EXPECT_EQ(window.minimumSizeHint().width(), 100 + 80 + 90 + 2 * 10 + 2 * 8);
    for (const int width : {400, 640, 1000}) {
        row->setGeometry({0, 0, width, 54});
        EXPECT_EQ(stop->geometry().right(), width - 8 - 1);
        EXPECT_EQ(stop->width(), 90);
        EXPECT_EQ(robots->x(), 8);
        EXPECT_EQ(tabs->x(), robots->geometry().right() + 1 + 10);
        EXPECT_EQ(tabs->width(), width == 400 ? 80 : 200) << width;
        EXPECT_LE(tabs->geometry().right(), stop->x());
    }
}

}  // namespace
}  // namespace leitstand
