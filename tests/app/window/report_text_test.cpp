// Dates, times and the words of the log in the PDF of each language.
#include <chrono>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QApplication>
#include <QDateTime>

#include "app/language/language.h"
#include "app/report/evidence_html.h"
#include "app/report/pdf/pdf_report.h"
#include "app/report/report_times.h"
#include "core/mission/state/find_state.h"
#include "tests/support/others_tools.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// 2026-11-21, 20:01:54 by the computer's time zone.
Time evening() {
    const QDateTime moment(QDate(2026, 11, 21), QTime(20, 1, 54));
    return Time(std::chrono::milliseconds(moment.toMSecsSinceEpoch()));
}

/// A victim whose form is filled in, in a mission of a profile of which nothing is sure.
ReportContent filled() {
    ReportContent content;
    content.name = "Contest-Team-Final";
    content.created = evening();
    content.model.facts.events = 1;
    content.model.facts.begin = content.model.facts.end = evening();
    content.model.facts.area = "yellow";
    ReportFind find;
    find.name = "V1";
    find.sample.found = evening();
    find.sample.situation = "trapped";
    find.sample.area = "red";
    content.model.finds.push_back(find);
    FindPages pages;
    GasTrace trace;
    trace.robot = "kurt3d";
    for (int i = 0; i < 30; ++i)
        trace.readings.push_back({evening() + std::chrono::seconds(2 * i), 400.0 + 9 * i});
    pages.gas.push_back(trace);
    content.finds.push_back(pages);
    ScoreProfile profile;
    profile.name = "2005";
    profile.version = "1.0";
    profile.unconfirmed = {"areas", "minutes"};
    content.profile = profile;
    return content;
}

struct Spoken {
    const char* code;
    QString date, clock;
};

class ReportWords : public testing::TestWithParam<Spoken> {
protected:
    void SetUp() override { ASSERT_TRUE(useLanguage(QLatin1String(GetParam().code))); }
    ~ReportWords() override { useLanguage(QStringLiteral("en")); }

    /// What a reader finds in the PDF of filled().
    std::string text() {
        const auto bytes = pdfOf(filled());
        EXPECT_TRUE(bytes.ok()) << bytes.error().text;
        if (!bytes) return {};
        writeText(m_folder / "report.pdf", *bytes);
        const ProcessOutcome read = readByPoppler(m_folder / "report.pdf");
        EXPECT_EQ(read.exitCode, 0) << read.err;
        return read.out;
    }
    const TemporaryFolder m_folder;
};

TEST_P(ReportWords, DatesAndTimesAreTheLanguages) {
    EXPECT_EQ(reportDate(evening()), GetParam().date);
    EXPECT_EQ(reportClock(evening()), GetParam().clock);
    EXPECT_THAT(text(), AllOf(HasSubstr(GetParam().date.toStdString()),
                              HasSubstr(GetParam().clock.toStdString()), Not(HasSubstr("2026-11-21"))));
}

TEST_P(ReportWords, TheLogsWordsAreTranslated) {
    const std::string pages = text();
    if (GetParam().code == std::string("en")) {
        EXPECT_THAT(pages,
                    AllOf(HasSubstr("trapped"), HasSubstr("yellow"), HasSubstr("weights of the areas")));
    } else {
        for (const char* english : {"trapped", "yellow", "areas", "minutes", "time of day", "measured by"})
            EXPECT_THAT(pages, Not(HasSubstr(english)));
    }
    if (GetParam().code == std::string("de")) {
        EXPECT_THAT(pages, AllOf(HasSubstr("eingeklemmt"), HasSubstr("gelb"), HasSubstr("rot")));
    }
    EXPECT_THAT(pages, HasSubstr("[ppm]")) << "the curve's axis";
}

INSTANTIATE_TEST_SUITE_P(
    Languages, ReportWords,
    testing::Values(Spoken{"en", QStringLiteral("11/21/2026"), QStringLiteral("8:01:54 PM")},
                    Spoken{"de", QStringLiteral("21.11.2026"), QStringLiteral("20:01:54")},
                    Spoken{"ja", QStringLiteral("2026/11/21"), QStringLiteral("20:01:54")}),
    [](const auto& one) { return std::string(one.param.code); });

TEST(GasCurve, OneReadingIsANumberWithoutACurve) {
    ASSERT_TRUE(useLanguage(QStringLiteral("en")));
    ReportContent content = filled();
    content.finds[0].gas[0].readings.resize(1);
    const auto bytes = pdfOf(content);
    ASSERT_TRUE(bytes) << bytes.error().text;
    const TemporaryFolder folder;
    writeText(folder / "report.pdf", *bytes);
    const ProcessOutcome read = readByPoppler(folder / "report.pdf");
    ASSERT_EQ(read.exitCode, 0) << read.err;
    EXPECT_THAT(read.out, AllOf(HasSubstr("400 ppm at 8:01:54 PM (kurt3d)"), Not(HasSubstr("[ppm]"))));
}

TEST(EvidenceLines, TellOfPicturesThatThereIsNoRoomFor) {
    FindPages pages;
    EXPECT_TRUE(evidenceLines(pages).isEmpty());
    pages.morePictures = 2;
    EXPECT_EQ(evidenceLines(pages).join("; ").toStdString(), "more pictures, in the mission: 2");
}

}  // namespace
}  // namespace leitstand::test
