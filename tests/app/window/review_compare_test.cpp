#include "tests/app/window/review_page.h"

#include <map>

#include <gmock/gmock.h>
#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QRadioButton>
#include <QTableView>
#include <QToolButton>

#include "app/language/language.h"
#include "app/services/comparison/map_comparing.h"
#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/source/review_comparison.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

class ReviewCompareTest : public ReviewPage {
protected:
    void open() {
        m_window->commands().trigger(QStringLiteral("review.compare"));
        ASSERT_TRUE(m_window->panes().isPaneVisible(QStringLiteral("compare")));
    }
    [[nodiscard]] int figures() const { return find<QTableView>("comparisonFigures").model()->rowCount(); }
};

TEST_F(ReviewCompareTest, TheMapRegisteredAgainIsShownBesideTheRecordedOne) {
    goTo(47.0);
    m_window->commands().trigger(QStringLiteral("review.compare"));
    EXPECT_TRUE(m_window->panes().isPaneVisible(QStringLiteral("compare")));
    auto& distances = find<QLineEdit>("compareDistances");
    auto& begin = find<QToolButton>("beginComparison");
    distances.setText(QStringLiteral("far"));
    EXPECT_FALSE(begin.isEnabled());
    distances.setText(QStringLiteral("1.0, 0.5"));
    EXPECT_FALSE(find<QRadioButton>("mapAgain").isVisible()) << "there is none yet";
    EXPECT_TRUE(find<QLabel>("comparisonNote").isVisible()) << "what the button does";
    lookAt("compare_first");
    begin.click();
    auto& figures = find<QTableView>("comparisonFigures");
    ASSERT_TRUE(soon([&] { return figures.model()->rowCount() > 0; })) << m_window->newest().toStdString();
    EXPECT_THAT(m_window->newest().toStdString(), HasSubstr("13 key scans registered again"));
    EXPECT_EQ(find<QTableView>("comparisonScans").model()->rowCount(), 13);
    int shown = 0;
    QObject::connect(m_bridge.get(), &MomentSource::mapChanged, m_window.get(),
                     [&shown](const MapPtr& map) { shown = static_cast<int>(map->scans.size()); });
    EXPECT_FALSE(find<QLabel>("comparisonNote").isVisible());
    EXPECT_THAT(label("mapTitle"), HasSubstr("recorded"));
    find<QRadioButton>("mapBoth").click();
    EXPECT_EQ(shown, 26);
    EXPECT_THAT(label("mapTitle"), HasSubstr("recorded (grey) and registered again"));
    lookAt("compared");
    goTo(12.0);
    EXPECT_EQ(shown, 26) << "it stays while the moment changes";
    find<QRadioButton>("mapAgain").click();
    EXPECT_EQ(shown, 13);
    EXPECT_THAT(label("mapTitle"), HasSubstr("· registered again ·"));
    find<QRadioButton>("mapRecorded").click();
    EXPECT_EQ(shown, 3) << "as then";
}

TEST_F(ReviewCompareTest, AComparisonGoesOnWhileTheWindowIsMadeAnew) {
    open();
    find<QLineEdit>("compareDistances").setText(QStringLiteral("0.7"));
    find<QToolButton>("beginComparison").click();
    openWindow();  // before anything of it could be told
    EXPECT_EQ(find<QLineEdit>("compareDistances").text(), QStringLiteral("0.7"));
    open();
    ASSERT_TRUE(soon([this] { return figures() > 0; })) << m_window->newest().toStdString();
    EXPECT_THAT(m_window->newest().toStdString(), HasSubstr("13 key scans registered again"));
    find<QRadioButton>("mapAgain").click();
    openWindow();
    EXPECT_GT(figures(), 0) << "at once";
    EXPECT_TRUE(find<QRadioButton>("mapAgain").isChecked());
    EXPECT_TRUE(soon([this] { return label("mapTitle").find("registered again") != std::string::npos; }));
}

TEST_F(ReviewCompareTest, TheNewestIsThereAgainWhenTheMissionIsReopened) {
    open();
    find<QLineEdit>("compareDistances").setText(QStringLiteral("0.7"));
    find<QToolButton>("beginComparison").click();
    ASSERT_TRUE(soon([this] { return figures() > 0; })) << m_window->newest().toStdString();
    TearDown();
    m_bridge = ReviewBridge::open(m_mission).value();
    openWindow();
    EXPECT_TRUE(soon([this] { return figures() > 0; }));
    EXPECT_EQ(find<QLineEdit>("compareDistances").text(), QStringLiteral("0.7"));
    EXPECT_TRUE(m_bridge->comparison().result()->remembered);
}

TEST_F(ReviewCompareTest, EveryMnemonicMeansOneThingInEveryLanguage) {
    for (const char* language : {"de", "ja", "en"}) {
        useLanguage(QLatin1String(language));
        openWindow();
        open();
        std::map<QChar, QStringList> meanings;
        const auto add = [&](const QString& text) {
            const QKeySequence keys = QKeySequence::mnemonic(text);
            if (!keys.isEmpty()) meanings[keys.toString().back()] += text;
        };
        for (const QAction* menu : m_window->menuBar()->actions()) add(menu->text());
        for (const QLabel* one : m_window->findChildren<QLabel*>())
            if (one->buddy() != nullptr && one->isVisible()) add(one->text());
        for (const QAbstractButton* one : m_window->findChildren<QAbstractButton*>())
            if (one->isVisible()) add(one->text());
        EXPECT_GE(meanings.size(), 10U) << language;
        for (const auto& [key, what] : meanings)
            EXPECT_EQ(what.size(), 1) << language << ": " << what.join(QStringLiteral("; ")).toStdString();
    }
}

}  // namespace
}  // namespace leitstand::test
