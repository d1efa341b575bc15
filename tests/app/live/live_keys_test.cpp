#include "tests/app/live/quiet_page.h"

#include <fstream>
#include <map>
#include <set>
#include <string>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QLabel>
#include <QMenu>
#include <QRegularExpression>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/places.h"

namespace leitstand::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;
using LiveKeys = QuietPage;

TEST_F(LiveKeys, NoCommandOpensAModalBox) {
    std::set<std::string> opened;
    const std::vector<QAction*> all = window().commands().all();
    for (QAction* one : all) {
        if (!one->isEnabled() || !one->isVisible()) continue;
        one->trigger();
        EXPECT_EQ(QApplication::activeModalWidget(), nullptr) << one->objectName().toStdString();
        for (QWidget* top : QApplication::topLevelWidgets()) {
            if (top == &window() || !top->isVisible() || !top->isWindow()) continue;
            EXPECT_FALSE(top->isModal()) << one->objectName().toStdString();
            opened.insert(one->objectName().toStdString());
            top->close();
        }
    }
    EXPECT_THAT(opened, IsSupersetOf({"keys", "about", "preflight.open", "mission.length", "mission.data",
                                      "mission.report", "layout.save", "pad.controls"}));
}

TEST_F(LiveKeys, NoTwoCommandsHaveTheSameKey) {
    std::map<QString, std::string> owners;
    for (const QAction* one : window().commands().all()) {
        for (const QKeySequence& keys : one->shortcuts()) {
            if (keys.isEmpty()) continue;
            const auto [owner, added] = owners.emplace(keys.toString(), one->objectName().toStdString());
            EXPECT_TRUE(added) << keys.toString().toStdString() << ": " << owner->second << " and "
                               << one->objectName().toStdString();
        }
    }
    EXPECT_GT(owners.size(), 40U);
}

TEST_F(LiveKeys, TheListOfKeysIsCompleteAndTrue) {
    press(Qt::Key_F1);
    const auto* dialog = window().findChild<QDialog*>(QStringLiteral("keysDialog"));
    ASSERT_NE(dialog, nullptr);
    EXPECT_TRUE(dialog->isVisible());
    std::set<std::string> texts;
    for (const QLabel* label : dialog->findChildren<QLabel*>()) texts.insert(label->text().toStdString());
    int keys = 0;
    for (const QAction* one : window().commands().all()) {
        if (one->shortcut().isEmpty() || !one->isVisible()) continue;
        EXPECT_THAT(texts, Contains(one->shortcut().toString(QKeySequence::NativeText).toStdString()))
            << one->objectName().toStdString();
        ++keys;
    }
    EXPECT_GT(keys, 40);
    EXPECT_THAT(texts, IsSupersetOf({"Select Kurt3D", "1", "stops all robots, always and everywhere",
                                     "W S A D, arrows", "while driving: halts the robot", "G, held",
                                     "Q E, Page Up, Page Down", "Number pad 4 6 8 2, 5"}));
    for (const std::string& text : texts) {
        EXPECT_THAT(text, Not(HasSubstr("ends measuring"))) << "Esc stops robots here";
        EXPECT_THAT(text, Not(HasSubstr("scans list"))) << "that is another window's";
    }
}

TEST_F(LiveKeys, MeasuringEndsByItsOwnKeysAndNotByEsc) {
    QAction& measure = command("measure");
    EXPECT_FALSE(measure.toolTip().contains(QStringLiteral("Esc"))) << measure.toolTip().toStdString();
    EXPECT_TRUE(measure.toolTip().endsWith(QStringLiteral("(Ctrl+Shift+M)")));
    QTest::qWait(300);         // the empty map has come
    measure.setEnabled(true);  // as with scans in it
    press(Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_TRUE(measure.isChecked());
    press(Qt::Key_Escape);
    EXPECT_TRUE(measure.isChecked()) << "Esc was for the robots";
    EXPECT_TRUE(soon([&] { return station().robot("kurt3d").stop.sent; }));
    press(Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_FALSE(measure.isChecked());
}

TEST_F(LiveKeys, TheManualListsTheKeysOfAllCommands) {
    std::ifstream manual(sourceFolder() + "/docs/operator.md");
    std::set<std::string> listed;
    for (std::string line; std::getline(manual, line);) {
        if (line.rfind("| ", 0) != 0) continue;
        const QString cell = QString::fromStdString(line).section(QLatin1Char('|'), 1, 1);
        const auto words = cell.split(QRegularExpression(QStringLiteral("[\\s,;*]+")), Qt::SkipEmptyParts);
        for (const QString& word : words) listed.insert(word.toStdString());
    }
    int keys = 0;
    for (const QAction* one : window().commands().all()) {
        if (one->shortcut().isEmpty() || !one->isVisible()) continue;
        EXPECT_THAT(listed, Contains(one->shortcut().toString(QKeySequence::PortableText).toStdString()))
            << one->objectName().toStdString();
        ++keys;
    }
    EXPECT_GT(keys, 40);
}

}  // namespace
}  // namespace leitstand::test
