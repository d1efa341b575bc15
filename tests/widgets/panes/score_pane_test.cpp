#include "widgets/score/score_pane.h"

#include <gtest/gtest.h>

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
    const QString nothing = QStringLiteral("Nothing to score yet: what a find brings is told here");
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

}  // namespace
}  // namespace leitstand::test
