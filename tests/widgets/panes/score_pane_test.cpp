#include "widgets/score/score_pane.h"

#include <gtest/gtest.h>
#include <QCoreApplication>

#include "tests/widgets/panes/shown.h"

namespace leitstand::test {
namespace {

bool says(QWidget& pane, const QString& words) {
    for (const PaintedText& text : paintedTexts(pane)) {
        if (text.text == words) return true;
    }
    return false;
}

TEST(ScorePane, NamesNoListThatIsEmpty) {
    ScorePane pane;
    pane.resize(500, 260);
    const QString more = QStringLiteral("More would bring");
    EXPECT_FALSE(says(pane, more)) << "before the first estimate";
    ScoreText text;
    text.score = QStringLiteral("12.5 points");
    text.advice = {{QStringLiteral("V1: tag"), QStringLiteral("+2.5"), Tone::Normal}};
    pane.show(text);
    EXPECT_TRUE(says(pane, more));
    EXPECT_TRUE(says(pane, text.score));
    text.advice.clear();
    pane.show(text);
    EXPECT_FALSE(says(pane, more));
}

TEST(ScorePane, TellsThatThereIsNothingToScoreYet) {
    ScorePane pane;
    pane.resize(500, 260);
    const QString nothing = QStringLiteral("Nothing to score yet: what a find brings is listed here");
    EXPECT_TRUE(says(pane, nothing)) << "before the first estimate";
    ScoreText text;
    text.score = QStringLiteral("0 points");
    pane.show(text);
    EXPECT_TRUE(says(pane, nothing));
    text.finds = {{QStringLiteral("V1"), QStringLiteral("20"), Tone::Normal}};
    pane.show(text);
    EXPECT_FALSE(says(pane, nothing));
    EXPECT_TRUE(says(pane, QStringLiteral("V1")));
}

TEST(ScorePane, TellsWhatAVictimsPointsAreMadeOfInANarrowPaneToo) {
    const QStringList items{QStringLiteral("map\u00a020/20"), QStringLiteral("place\u00a010/10"),
                            QStringLiteral("form\u00a02/2"),  QStringLiteral("motion\u00a00/2"),
                            QStringLiteral("heat\u00a00/2"),  QStringLiteral("sound\u00a00/2"),
                            QStringLiteral("CO₂\u00a02/2"),   QStringLiteral("situation\u00a00/5"),
                            QStringLiteral("tag\u00a05/5")};
    ScoreText text;
    text.score = QStringLiteral("18.5 points");
    text.finds = {{QStringLiteral("V1 · area × 0.50"), QStringLiteral("19.5"), Tone::Normal,
                   items.join(QStringLiteral(", "))},
                  {QStringLiteral("2 × touched the arena"), QStringLiteral("−1"), Tone::Attention}};
    ScorePane pane;
    pane.show(text);
    pane.resize(300, 320);
    pane.show();
    QCoreApplication::processEvents();  // lines find their heights
    (void)pictureOf(pane, pane.size(), QStringLiteral("score"));
    EXPECT_EQ(textFaults(pane), QStringList());
    QString painted;
    for (const PaintedText& one : paintedTexts(pane)) painted += one.text;
    for (const QString& item : items)
        EXPECT_TRUE(painted.contains(item)) << item.toStdString() << " in " << painted.toStdString();
}

}  // namespace
}  // namespace leitstand::test
