#include "app/language/language.h"

#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QProcess>
#include <QRegularExpression>
#include <QXmlStreamReader>

#include "core/base/words.h"
#include "tests/support/missing_tool.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"
#include "widgets/models/numbers.h"

namespace leitstand::test {
namespace {

struct Text {
    QString context, source, translation;
    bool finished = true;
};

std::vector<Text> textsOf(const QString& file) {
    std::vector<Text> all;
    QFile in(file);
    EXPECT_TRUE(in.open(QIODevice::ReadOnly)) << file.toStdString();
    QXmlStreamReader xml(&in);
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QLatin1String("name")) {
            context = xml.readElementText();
        } else if (xml.name() == QLatin1String("source")) {
            all.push_back({context, xml.readElementText(), {}, true});
        } else if (xml.name() == QLatin1String("translation") && !all.empty()) {
            all.back().finished = !xml.attributes().hasAttribute(QLatin1String("type"));
            all.back().translation = xml.readElementText();
        }
    }
    EXPECT_FALSE(xml.hasError()) << file.toStdString() << ": " << xml.errorString().toStdString();
    return all;
}

QStringList placeholdersOf(const QString& text) {
    QStringList all;
    auto found = QRegularExpression(QStringLiteral("%[0-9]|\\{[^}]*\\}")).globalMatch(text);
    while (found.hasNext()) all += found.next().captured();
    all.sort();
    all.removeDuplicates();
    return all;
}

class Translation : public testing::TestWithParam<const char*> {
protected:
    ~Translation() override { useLanguage(QStringLiteral("en")); }
    [[nodiscard]] static QString file() {
        return QString::fromStdString(sourceFolder() + "/translations/leitstand_%1.ts")
            .arg(QLatin1String(GetParam()));
    }
};

TEST_P(Translation, IsWholeAndKeepsWhatIsFilledIn) {
    const auto texts = textsOf(file());
    EXPECT_GT(texts.size(), 1'000U);
    for (const Text& one : texts) {
        const std::string where = one.context.toStdString() + ": " + one.source.toStdString();
        EXPECT_TRUE(one.finished && !one.translation.isEmpty()) << where;
        EXPECT_EQ(placeholdersOf(one.source), placeholdersOf(one.translation)) << where;
        EXPECT_EQ(one.source.count(QLatin1Char('\t')), one.translation.count(QLatin1Char('\t'))) << where;
    }
}

TEST_P(Translation, HasEveryTextOfTheProgram) {
    const QString lupdate = QStringLiteral("/usr/lib/qt6/bin/lupdate");
    if (!QFile::exists(lupdate)) LEITSTAND_MISSING_TOOL("Qt's lupdate is not installed (qt6-l10n-tools)");
    const TemporaryFolder folder;
    const QString copy = QString::fromStdString((folder / "texts.ts").string());
    ASSERT_TRUE(QFile::copy(file(), copy));
    QProcess update;
    update.setWorkingDirectory(QString::fromStdString(sourceFolder()));
    update.start(lupdate,
                 {"-silent", "-no-obsolete", "-locations", "none", "-I", ".", "app", "core", "widgets",
                  "-extensions", "cpp,h", "-tr-function-alias", "QT_TRANSLATE_NOOP+=translatable",
                  "-source-language", "en", "-target-language", QLatin1String(GetParam()), "-ts", copy});
    ASSERT_TRUE(update.waitForFinished(120'000));
    ASSERT_EQ(update.exitCode(), 0);
    for (const Text& one : textsOf(copy))
        EXPECT_TRUE(one.finished) << one.context.toStdString() << ": " << one.source.toStdString()
                                  << " (translations/update.sh brings it into the files)";
}

TEST_P(Translation, IsWhatTheStationItselfSpeaks) {
    const auto reported = [] {
        return fill(translate("leitstand::Station", "{} filed: press again to confirm"), std::string("V1"));
    };
    EXPECT_EQ(reported(), "V1 filed: press again to confirm");
    ASSERT_TRUE(useLanguage(QLatin1String(GetParam())));
    EXPECT_NE(reported(), "V1 filed: press again to confirm");
    EXPECT_NE(reported().find("V1"), std::string::npos);
}

TEST_P(Translation, IsSpokenAtOnceAndLeftAgain) {
    const auto text = [] { return QCoreApplication::translate("leitstand::AlarmPanel", "No alarms"); };
    EXPECT_EQ(text(), QStringLiteral("No alarms"));
    ASSERT_TRUE(useLanguage(QLatin1String(GetParam())));
    EXPECT_NE(text(), QStringLiteral("No alarms"));
    EXPECT_EQ(presentLanguage(), QLatin1String(GetParam()));
    useLanguage(QStringLiteral("en"));
    EXPECT_EQ(text(), QStringLiteral("No alarms"));
}

INSTANTIATE_TEST_SUITE_P(Languages, Translation, testing::Values("de", "ja"),
                         [](const auto& one) { return std::string(one.param); });

TEST(Languages, NumbersFollow) {
    useLanguage(QStringLiteral("de"));
    EXPECT_EQ(numberText(1.5, 1), QStringLiteral("1,5"));
    useLanguage(QStringLiteral("en"));
    EXPECT_EQ(numberText(1.5, 1), QStringLiteral("1.5"));
    EXPECT_FALSE(useLanguage(QStringLiteral("xx")));
    EXPECT_EQ(presentLanguage(), QStringLiteral("en"));
}

}  // namespace
}  // namespace leitstand::test
