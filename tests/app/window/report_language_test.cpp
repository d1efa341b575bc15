// The hand-in of the shipped mission in each language of the window.
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QApplication>

#include "app/language/language.h"
#include "app/report/pdf/pdf_report.h"
#include "app/services/handin/writing/report_writer.h"
#include "tests/support/missing_tool.h"
#include "tests/support/others_tools.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "widgets/painting/theme.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

struct Spoken {
    const char* code;
    std::vector<std::string> words;
};

/// How many pixels of the first of @p pages are nearly black; 50 dots an inch.
std::size_t blackPixelsOf(const fs::path& pages, const fs::path& picture) {
    const ProcessOutcome drawn = runProcess(
        "/usr/bin/pdftoppm",
        {"-gray", "-r", "50", "-f", "1", "-l", "1", "-singlefile", pages.string(), picture.string()});
    EXPECT_EQ(drawn.exitCode, 0) << drawn.err;
    std::ifstream in(picture.string() + ".pgm", std::ios::binary);
    std::string magic;
    int width = 0, height = 0, most = 0;
    EXPECT_TRUE(in >> magic >> width >> height >> most) << drawn.err;
    in.get();
    std::string pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), ' ');
    in.read(pixels.data(), static_cast<std::streamsize>(pixels.size()));
    return static_cast<std::size_t>(std::count_if(
        pixels.begin(), pixels.end(), [](char pixel) { return static_cast<unsigned char>(pixel) < 96; }));
}

/// Words of @p pages, by poppler, that reach out of their page's margins or lie on another word.
std::vector<std::string> misplacedWords(const fs::path& pages) {
    const ProcessOutcome boxes = runProcess("/usr/bin/pdftotext", {"-bbox", pages.string(), "-"});
    EXPECT_EQ(boxes.exitCode, 0) << boxes.err;
    struct Word {
        double left, top, right, bottom;  ///< [pt]
        std::string text;
    };
    const std::string number = R"re(="([-0-9.]+)")re";
    const std::regex pageLine("<page width" + number + " height" + number);
    const std::regex wordLine("<word xMin" + number + " yMin" + number + " xMax" + number + " yMax" + number +
                              ">(.*)</word>");
    constexpr double Margin = 30.0, Touch = 0.5, OfLine = 0.35;
    std::vector<std::string> misplaced;
    std::vector<Word> words;
    double width = 0.0, height = 0.0;
    std::istringstream lines(boxes.out);
    for (std::string text; std::getline(lines, text);) {
        std::smatch found;
        if (std::regex_search(text, found, pageLine)) {
            width = std::stod(found[1]);
            height = std::stod(found[2]);
            words.clear();
        }
        if (!std::regex_search(text, found, wordLine)) continue;
        const Word word{std::stod(found[1]), std::stod(found[2]), std::stod(found[3]), std::stod(found[4]),
                        found[5]};
        if (word.left < Margin || word.right > width - Margin || word.top < Margin ||
            word.bottom > height - Margin)
            misplaced.push_back(word.text + " at the edge");
        for (const Word& other : words) {
            const double beside = std::min(word.right, other.right) - std::max(word.left, other.left);
            const double below = std::min(word.bottom, other.bottom) - std::max(word.top, other.top);
            const double line = std::min(word.bottom - word.top, other.bottom - other.top);
            if (beside > Touch && below > OfLine * line) misplaced.push_back(word.text + " on " + other.text);
        }
        words.push_back(word);
    }
    EXPECT_FALSE(words.empty()) << "no word was read";
    return misplaced;
}

class ReportLanguage : public testing::TestWithParam<Spoken> {
protected:
    ~ReportLanguage() override { useLanguage(QStringLiteral("en")); }
};

TEST_P(ReportLanguage, IsTheWindows) {
    const TemporaryFolder folder;
    ASSERT_TRUE(useLanguage(QLatin1String(GetParam().code)));
    applyTheme(*qApp, Theme::Dark);
    ReportOptions options;
    options.pdf = &pdfOf;
    const fs::path out = folder / "out", pages = out / "RoboCup2026-Leitstand-Sample.pdf";
    const auto written = writeReport(fs::path(sourceFolder()) / "resources/samples/yellow-7", out, options);
    ASSERT_TRUE(written) << written.error().text;
    EXPECT_TRUE(written->whole());
    const ProcessOutcome text = readByPoppler(pages);
    LEITSTAND_NEEDS(text);
    for (const std::string& word : GetParam().words) EXPECT_THAT(text.out, HasSubstr(word));
    EXPECT_THAT(misplacedWords(pages), testing::IsEmpty());
    EXPECT_GT(blackPixelsOf(pages, folder / "first"), 2000U)
        << "is read on white paper, in a dark window too";
    if (GetParam().code != std::string("en")) {
        for (const char* english : {"Searched", "confirmed", "Victim", "Infrared", "above the floor"})
            EXPECT_THAT(text.out, Not(HasSubstr(english)));
    }
    if (const char* pictures = std::getenv("LEITSTAND_PICTURES")) {  // for people
        const fs::path name = fs::path(pictures) / (std::string("report_") + GetParam().code);
        EXPECT_EQ(
            runProcess("/usr/bin/pdftoppm", {"-r", "70", "-png", pages.string(), name.string()}).exitCode, 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Languages, ReportLanguage,
                         testing::Values(Spoken{"en", {"Victim", "confirmed", "Searched"}},
                                         Spoken{"de", {"Opfer", "bestätigt", "Abgesucht", "0,25 bis 0,35 m"}},
                                         Spoken{"ja", {"被災者", "探索"}}),
                         [](const auto& one) { return std::string(one.param.code); });

/// The last line of a page of @p text that is not its foot.
std::string lastLineOf(const std::string& text) {
    std::istringstream lines(text);
    std::string line, last;
    while (std::getline(lines, line)) {
        const bool foot = line.find("page ") != std::string::npos;
        if (line.find_first_not_of(" \f") != std::string::npos && !foot) last = line;
    }
    return last;
}

TEST(ReportPages, NoHeadingIsLeftAloneAtAPagesEnd) {
    const TemporaryFolder folder;
    applyTheme(*qApp, Theme::Light);
    ReportContent content;
    content.name = "Contest-Team-Final";
    std::set<std::size_t> ends;
    for (std::size_t finds = 1; finds <= 34; ++finds) {
        ReportFind find;
        find.name = "V" + std::to_string(finds);
        content.model.finds.push_back(find);
        content.finds.emplace_back();
        const auto bytes = pdfOf(content);
        ASSERT_TRUE(bytes) << bytes.error().text;
        writeText(folder / "report.pdf", *bytes);
        const ProcessOutcome text = readByPoppler(folder / "report.pdf");
        LEITSTAND_NEEDS(text);
        std::istringstream pages(text.out);
        std::string page;
        for (std::size_t number = 1; std::getline(pages, page, '\f'); ++number) {
            for (const char* heading : {"Robots", "Finds", "What was computed where", "The way to"}) {
                EXPECT_THAT(lastLineOf(page), Not(StartsWith(heading))) << finds << " finds, page " << number;
            }
            if (page.find("What was computed where") != std::string::npos) ends.insert(number);
        }
    }
    EXPECT_GT(ends.size(), 1U) << "the list was never long enough to push a heading over a page's end";
}

}  // namespace
}  // namespace leitstand::test
