// The pages of the PDF with the map: what was found can be read, however large the map is.
#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/report/sample_mission.h"
#include "tests/support/missing_tool.h"
#include "tests/support/others_tools.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

/// A word of a page and its place [pt].
struct PrintedWord {
    std::string text;
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;

    [[nodiscard]] bool overlaps(const PrintedWord& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};
using PrintedPage = std::vector<PrintedWord>;

/// The words of every page of a PDF, as `pdftotext -bbox` tells them.
std::vector<PrintedPage> pagesOf(const std::string& boxes) {
    static const std::regex Word(
        R"re(<word xMin="([0-9.]+)" yMin="([0-9.]+)" xMax="([0-9.]+)" yMax="([0-9.]+)">([^<]*)</word>)re");
    std::vector<PrintedPage> pages;
    for (auto page = boxes.find("<page "); page != std::string::npos;) {
        const auto next = boxes.find("<page ", page + 1);
        const std::string part = boxes.substr(page, next - page);
        PrintedPage words;
        for (std::sregex_iterator word(part.begin(), part.end(), Word), end; word != end; ++word) {
            const auto number = [&](std::size_t group) { return std::stod((*word)[group]); };
            words.push_back({(*word)[5], number(1), number(2), number(3), number(4)});
        }
        pages.push_back(std::move(words));
        page = next;
    }
    return pages;
}

bool has(const PrintedPage& page, const std::string& text) {
    return std::any_of(page.begin(), page.end(), [&](const PrintedWord& word) { return word.text == text; });
}

/// The names of finds on @p page below the caption of its map: the end of a table may stand above.
std::vector<PrintedWord> namesOn(const PrintedPage& page) {
    static const std::regex Name("[VHQO][0-9]+");
    const auto caption = std::find_if(page.begin(), page.end(), [](const PrintedWord& word) {
        return word.text == "RoboCup2013-Deutschland1-Final_1:";
    });
    std::vector<PrintedWord> names;
    std::copy_if(page.begin(), page.end(), std::back_inserter(names), [&](const PrintedWord& word) {
        return std::regex_match(word.text, Name) && word.top > caption->bottom;
    });
    return names;
}

/// The pages of the map in the report of a mission.
std::vector<PrintedPage> mapPages(const SampleMission& what, ProcessOutcome& read) {
    const TemporaryFolder folder;
    writeSampleMission(folder / "final", what);
    const ProcessOutcome made = runProcess(
        program("leitstandctl"), {"report", (folder / "final").string(), "--out", (folder / "out").string()});
    EXPECT_EQ(made.exitCode, 0) << made.err;
    read = boxesByPoppler(folder / "out" / "RoboCup2013-Deutschland1-Final_1.pdf");
    std::vector<PrintedPage> pages = pagesOf(read.out);
    std::erase_if(pages,
                  [](const PrintedPage& page) { return !has(page, "RoboCup2013-Deutschland1-Final_1:"); });
    return pages;
}

void expectReadable(const std::vector<PrintedWord>& names, const std::set<std::string>& expected) {
    std::set<std::string> found;
    for (const PrintedWord& name : names) {
        EXPECT_TRUE(found.insert(name.text).second) << name.text << " is there once";
        EXPECT_GE(name.bottom - name.top, 7.0) << name.text;
    }
    EXPECT_EQ(found, expected);
    for (std::size_t i = 0; i < names.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(names[i].overlaps(names[j])) << names[i].text << " and " << names[j].text;
    }
}

TEST(MapPage, TheNamesOfTwelveVictimsInAHallOfFortyMetresCanBeRead) {
    ProcessOutcome read;
    const auto pages = mapPages({.finds = false, .victims = 12}, read);
    LEITSTAND_NEEDS(read);
    ASSERT_EQ(pages.size(), 2U) << "a page for each height";
    std::set<std::string> all;
    for (int i = 1; i <= 12; ++i) all.insert(fmt::format("V{}", i));
    for (const PrintedPage& page : pages) {
        expectReadable(namesOn(page), all);
        for (const char* word : {"x", "y", "1", "m"}) EXPECT_TRUE(has(page, word)) << "scale and orientation";
    }
    // x is up, y is left: V4 is at (20, -20), V9 at (-20, 20), V12 at (20, 20).
    std::map<std::string, PrintedWord> at;
    for (const PrintedWord& name : namesOn(pages.front())) at[name.text] = name;
    EXPECT_LT(at["V4"].bottom + 200.0, at["V9"].top);
    EXPECT_GT(at["V4"].left, at["V9"].right + 200.0);
    EXPECT_NEAR(at["V12"].top, at["V4"].top, 60.0);
}

TEST(MapPage, EveryKindOfFindIsNamedInARoomToo) {
    ProcessOutcome read;
    const auto pages = mapPages({}, read);
    LEITSTAND_NEEDS(read);
    ASSERT_EQ(pages.size(), 2U);
    for (const PrintedPage& page : pages) expectReadable(namesOn(page), {"V1", "V2", "H1", "Q1", "O1"});
}

TEST(MapPage, NamesOfMoreFindsThanFitBesideEachOtherDoNotOverlapEither) {
    ProcessOutcome read;
    const auto pages = mapPages({.finds = false, .victims = 60}, read);
    LEITSTAND_NEEDS(read);
    ASSERT_EQ(pages.size(), 2U);
    std::set<std::string> all;  // five times at the same dozen places
    for (int i = 1; i <= 60; ++i) all.insert(fmt::format("V{}", i));
    expectReadable(namesOn(pages.front()), all);
}

}  // namespace
}  // namespace leitstand::test
