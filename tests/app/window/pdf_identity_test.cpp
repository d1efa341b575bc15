// What tells one PDF from another: when it was made, and by which identity.
#include "app/report/pdf/pdf_identity.h"

#include <chrono>
#include <filesystem>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QApplication>
#include <QDateTime>

#include "app/language/language.h"
#include "app/report/pdf/pdf_report.h"
#include "app/services/handin/writing/report_writer.h"
#include "tests/support/others_tools.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr Time Made = Time(std::chrono::seconds(1'794'000'000));
constexpr Time Later = Time(std::chrono::seconds(1'794'003'723));

QByteArray stated(Time time, const char* format) {
    return QDateTime::fromSecsSinceEpoch(
               std::chrono::duration_cast<std::chrono::seconds>(time.time_since_epoch()).count())
        .toUTC()
        .toString(QString::fromLatin1(format))
        .toLatin1();
}

TEST(PdfIdentity, DatesAreTheStatedOnesAndNothingMoves) {
    const QByteArray old =
        "%PDF-1.6\n/CreationDate (D:20200101000000Z)\n/ModDate (D:20200101000000Z)\n"
        "<xmp:CreateDate>2020-01-01T00:00:00Z</xmp:CreateDate>\nrest";
    const QByteArray made = withIdentity(old, Made);
    EXPECT_EQ(made.size(), old.size());
    EXPECT_TRUE(made.contains("/CreationDate (D:" + stated(Made, "yyyyMMddHHmmss") + "Z)"));
    EXPECT_TRUE(made.contains("/ModDate (D:" + stated(Made, "yyyyMMddHHmmss") + "Z)"));
    EXPECT_TRUE(made.contains("<xmp:CreateDate>" + stated(Made, "yyyy-MM-ddTHH:mm:ss") + "Z<"));
    EXPECT_TRUE(made.endsWith("\nrest"));
}

TEST(PdfIdentity, ADateWithAnOffsetKeepsItsForm) {
    const QByteArray made = withIdentity("/CreationDate (D:20200101000000+01'00')", Made);
    const QString local =
        QDateTime::fromSecsSinceEpoch(1'794'000'000).toString(QStringLiteral("yyyyMMddHHmmss"));
    EXPECT_EQ(made.size(), 39);
    EXPECT_TRUE(made.startsWith("/CreationDate (D:" + local.toLatin1()));
    EXPECT_TRUE(made.endsWith("')"));
}

TEST(PdfIdentity, IdentitiesAreOfTheContent) {
    const auto pdf = [](const char* content, const char* id, const char* uuid) {
        return QByteArray("/ID [ <") + id + "> <" + id + "> ]\n<x>uuid:" + uuid + "</x>\n" + content;
    };
    const QByteArray one =
        withIdentity(pdf("map", "0123456789abcdef", "01234567-89ab-cdef-0123-456789abcdef"), Made);
    const QByteArray same =
        withIdentity(pdf("map", "fedcba9876543210", "76543210-ba98-fedc-3210-fedcba987654"), Made);
    const QByteArray other =
        withIdentity(pdf("Map", "0123456789abcdef", "01234567-89ab-cdef-0123-456789abcdef"), Made);
    EXPECT_EQ(one, same);
    EXPECT_NE(one.left(24), other.left(24));
    EXPECT_EQ(one.indexOf("> <"), 23);
    EXPECT_EQ(one.mid(one.indexOf("uuid:") + 13, 1), "-");
}

TEST(PdfIdentity, WhatHasNoDatesOrOthersIsLeftAsItIs) {
    for (const QByteArray& bytes :
         {QByteArray(), QByteArray("%PDF-1.4\nno date"), QByteArray("/CreationDate (D:"),
          QByteArray("/CreationDate (yesterday)"), QByteArray("/CreationDate (D:2020)"),
          QByteArray("/ID [ <not a number> ]"), QByteArray("uuid:something else<")})
        EXPECT_EQ(withIdentity(bytes, Made), bytes) << bytes.toStdString();
}

/// The shipped mission's report, made at a time, and its PDF.
fs::path report(const fs::path& out, Time created) {
    ReportOptions options;
    options.pdf = &pdfOf;
    options.created = created;
    const auto written = writeReport(fs::path(sourceFolder()) / "resources/samples/yellow-7", out, options);
    EXPECT_TRUE(written.ok()) << written.error().text;
    EXPECT_TRUE(written->whole());
    return out / "RoboCup2026-Leitstand-Sample.pdf";
}

TEST(PdfIdentity, ReportsMadeAtTheSameTimeHaveTheSameBytes) {
    const TemporaryFolder folder;
    ASSERT_TRUE(useLanguage(QStringLiteral("en")));
    const fs::path first = report(folder / "first", Made), again = report(folder / "again", Made),
                   later = report(folder / "later", Later);
    for (const auto& entry : fs::directory_iterator(folder / "first")) {
        const fs::path name = entry.path().filename();
        EXPECT_TRUE(readText(entry.path()) == readText(folder / "again" / name)) << name;
        const bool timed = name.extension() == ".pdf" || name == "SHA256SUMS";
        EXPECT_EQ(readText(entry.path()) == readText(folder / "later" / name), !timed) << name;
    }
    EXPECT_THAT(readText(first), HasSubstr("/CreationDate (D:202611"));
    // What a reader sees differs in the line that says when it was made.
    const auto shown = [](const fs::path& pages) {
        const ProcessOutcome text = readByPoppler(pages);
        EXPECT_EQ(text.exitCode, 0) << text.err;
        std::string rest = text.out;
        const auto line = rest.find("Report made");
        EXPECT_NE(line, std::string::npos);
        if (line != std::string::npos) rest.erase(line, rest.find('\n', line) - line);
        std::erase_if(rest, [](char letter) { return letter == ' '; });  // columns follow what is in them
        return std::pair(text.out, rest);
    };
    const auto early = shown(first), late = shown(later);
    EXPECT_NE(early.first, late.first);
    EXPECT_EQ(early.second, late.second);
}

}  // namespace
}  // namespace leitstand::test
