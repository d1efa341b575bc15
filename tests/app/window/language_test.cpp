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

/// The languages of the window that texts are translated into.
std::vector<std::string> translated() {
    std::vector<std::string> codes;
    for (const Language& one : languages())
        if (one.code != QLatin1String("en")) codes.push_back(one.code.toStdString());
    return codes;
}

class Translation : public testing::TestWithParam<std::string> {
protected:
    ~Translation() override { useLanguage(QStringLiteral("en")); }
    [[nodiscard]] static QString file() {
        return QString::fromStdString(sourceFolder() + "/translations/leitstand_%1.ts").arg(code());
    }
    [[nodiscard]] static QString code() { return QString::fromStdString(GetParam()); }
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
                  "-source-language", "en", "-target-language", code(), "-ts", copy});
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
    ASSERT_TRUE(useLanguage(code()));
    EXPECT_NE(reported(), "V1 filed: press again to confirm");
    EXPECT_NE(reported().find("V1"), std::string::npos);
}

TEST_P(Translation, IsSpokenAtOnceAndLeftAgain) {
    const auto text = [] { return QCoreApplication::translate("leitstand::AlarmPanel", "No alarms"); };
    EXPECT_EQ(text(), QStringLiteral("No alarms"));
    ASSERT_TRUE(useLanguage(code()));
    EXPECT_NE(text(), QStringLiteral("No alarms"));
    EXPECT_EQ(presentLanguage(), code());
    useLanguage(QStringLiteral("en"));
    EXPECT_EQ(text(), QStringLiteral("No alarms"));
}

INSTANTIATE_TEST_SUITE_P(Languages, Translation, testing::ValuesIn(translated()),
                         [](const auto& one) { return one.param; });

TEST(Languages, AreThoseThatThereIsAFileOf) {
    std::vector<std::string> files;
    for (const auto& one : std::filesystem::directory_iterator(sourceFolder() + "/translations"))
        if (one.path().extension() == ".ts") files.push_back(one.path().stem().string());
    std::vector<std::string> expected;
    for (const std::string& code : translated()) expected.push_back("leitstand_" + code);
    EXPECT_THAT(files, testing::UnorderedElementsAreArray(expected));
}

TEST(Languages, AreAllSpokenByTheDesktop) {
    const auto times = [](const QString& text, const std::string& code) {
        const QString one = QString::fromStdString(code);
        return text.count(QStringLiteral("[%1]=").arg(one)) +
               text.count(QStringLiteral("xml:lang=\"%1\"").arg(one));
    };
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(sourceFolder() + "/packaging/desktop")) {
        if (entry.path().extension() == ".cpp") continue;
        const QString text = QString::fromStdString(readText(entry.path()));
        EXPECT_GT(times(text, "de"), 0) << entry.path();
        for (const std::string& code : translated())
            EXPECT_EQ(times(text, code), times(text, "de")) << entry.path() << ": " << code;
        ++files;
    }
    EXPECT_GE(files, 4);
}

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
