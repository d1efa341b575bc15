#include "core/io/handin/csv_fields.h"

#include <cmath>
#include <cstdlib>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace leitstand {
namespace {

/// What CsvReader makes of a line of one field.
std::string readBack(const std::string& field) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "a.csv", field + "\n");
    auto opened = CsvReader::open(folder / "a.csv");
    if (!opened) return opened.error().text;
    CsvReader reader = std::move(opened).value();
    std::vector<std::string> fields;
    if (!reader.next(fields)) return "nothing";
    return fields.size() == 1 ? fields[0] : "more fields";
}

/// What a spreadsheet takes the field for: a formula begins with one of these behind quotes and blanks.
bool calculates(std::string field) {
    if (field.starts_with('"')) field.erase(0, 1);
    field.erase(0, field.find_first_not_of(" \t\r\n"));
    if (field.empty()) return false;
    char* end = nullptr;
    const double number = std::strtod(field.c_str(), &end);
    if (std::isfinite(number) && (*end == '\0' || std::string(end) == "\"")) return false;
    for (const char* sign : {"=", "+", "-", "@", "＝", "＋", "－", "＠"}) {
        if (field.starts_with(sign)) return true;
    }
    return false;
}

TEST(CsvFields, TextsNeverBeginAFormula) {
    EXPECT_EQ(quotedField("\t"), "\"'\t\"") << "found by fuzzing";
    EXPECT_EQ(csvField("=1+1"), "'=1+1");
    EXPECT_EQ(csvField("=HYPERLINK(\"http://x\",\"y\")"), "\"'=HYPERLINK(\"\"http://x\"\",\"\"y\"\")\"");
    for (const char* text : {"=cmd|' /C calc'!A0", "+1+cmd|x", "-2+3", "@SUM(A1)", "\t=1", "\r=1", "\n=1",
                             "  =1", "-inf", "+", "＝1+1", "'=1"}) {
        EXPECT_FALSE(calculates(csvField(text))) << text;
        EXPECT_FALSE(calculates(quotedField(text))) << text;
    }
}

TEST(CsvFields, NumbersAndOtherTextsStayAsTheyAre) {
    for (const char* text :
         {"-5", "+3.25", "-1e-3", "17", "a=b", "it's", "'quoted'", "12:03:04", "Bett - oben", "'", ""}) {
        EXPECT_EQ(csvField(text), text);
        EXPECT_EQ(readBack(csvField(text)), text);
    }
}

TEST(CsvFields, WhatIsReadAgainIsWhatWasWritten) {
    for (const char* text : {"=1+1", "'=1+1", "''=1", "@x", "-a", "+b, c", "=\"q\"", "＠"}) {
        EXPECT_EQ(readBack(csvField(text)), text);
        EXPECT_EQ(readBack(quotedField(text)), text);
    }
    std::mt19937 random(1);
    const std::string signs = "'=+-@\",1a ";
    for (int round = 0; round < 2'000; ++round) {
        std::string text(random() % 7, ' ');
        for (char& letter : text) letter = signs[random() % signs.size()];
        // Readers take blanks about fields away.
        if (text.starts_with(' ') || text.ends_with(' ')) continue;
        EXPECT_EQ(readBack(quotedField(text)), text);
        EXPECT_FALSE(calculates(csvField(text))) << text;
    }
}

}  // namespace
}  // namespace leitstand
