// Comments and documents as a newcomer reads them: each sentence once, each citation to something that is
// there.
#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/architecture/prose.h"
#include "tests/architecture/sources.h"
#include "tests/support/places.h"

namespace leitstand::test {
namespace {

std::vector<std::string> productSources() {
    return sources({"core", "transport", "robots", "widgets", "app"});
}

std::vector<std::string> documents() {
    std::vector<std::string> all = {"README.md", "CONTRIBUTING.md"};
    for (const auto& entry : std::filesystem::recursive_directory_iterator(sourceFolder() + "/docs"))
        if (entry.path().extension() == ".md")
            all.push_back(std::filesystem::relative(entry.path(), sourceFolder()).generic_string());
    return all;
}

std::set<std::string> headings(const std::string& document) {
    std::set<std::string> all;
    std::istringstream in(content(document));
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("#")) all.insert(line.substr(line.find_first_not_of("# ")));
    return all;
}

/// How GitHub names the place of a heading in a link.
std::string anchorOf(const std::string& heading) {
    std::string anchor;
    for (const unsigned char c : heading) {
        if (c == ' ' || c == '-')
            anchor += '-';
        else if (std::isalnum(c) != 0 || c == '_' || c >= 0x80)
            anchor += static_cast<char>(std::tolower(c));
    }
    return anchor;
}

TEST(Prose, SentencesOfCommentsAreFoundAcrossLines) {
    const auto found = sentences(
        "/// One sentence\n/// on two lines. Another:\n/// - an item\nint x;  ///< of x\n"
        "int y;  ///< of y,\n        ///< which goes on\n/// Of z.\nint z;\n");
    std::vector<std::string> texts;
    for (const Sentence& one : found) texts.push_back(one.text);
    EXPECT_THAT(texts, testing::ElementsAre("One sentence on two lines.", "Another:", "- an item", "of x",
                                            "of y, which goes on", "Of z."));
    EXPECT_EQ(found.front().words(), 5);
}

TEST(Prose, NoSentenceOfACommentIsLongerThan30Words) {
    for (const std::string& file : productSources())
        for (const Sentence& one : sentences(content(file)))
            EXPECT_LE(one.words(), 30) << file << ":" << one.line << ": " << one.text;
}

TEST(Prose, WordsThatHaveToBeReadTwiceStayFew) {
    static const std::regex word(R"(\b(told|anew|likewise|of which)\b)", std::regex::icase);
    std::vector<std::string> lines;
    const auto look = [&](const std::string& file) {
        std::istringstream in(content(file));
        for (std::string line; std::getline(in, line);)
            if (std::regex_search(line, word)) lines.push_back(file + ": " + line);
    };
    for (const std::string& file : productSources()) look(file);
    for (const char* language : {"de", "ja"}) look(std::string("translations/leitstand_") + language + ".ts");
    EXPECT_LT(lines.size(), 30U) << testing::PrintToString(lines);
}

TEST(Documents, HaveAtMost250Lines) {
    for (const std::string& file : documents()) {
        const std::string text = content(file);
        EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 250)
            << file << ": split it, or move figures to docs/measured";
    }
}

TEST(Documents, LinksLeadSomewhere) {
    static const std::regex link(R"(\]\(([^)#\s]*)(?:#([^)\s]*))?\))");
    for (const std::string& file : documents()) {
        const std::string text = content(file);
        const auto folder = std::filesystem::path(file).parent_path();
        for (std::sregex_iterator one(text.begin(), text.end(), link), end; one != end; ++one) {
            const std::string target = (*one)[1], anchor = (*one)[2];
            if (target.find("://") != std::string::npos || target.starts_with("mailto:")) continue;
            const std::string to =
                target.empty() ? file : (folder / target).lexically_normal().generic_string();
            if (!std::filesystem::exists(sourceFolder() + "/" + to)) {
                ADD_FAILURE() << file << ": there is no " << to;
                continue;
            }
            if (anchor.empty()) continue;
            const std::set<std::string> all = headings(to);
            EXPECT_TRUE(std::any_of(all.begin(), all.end(),
                                    [&](const std::string& heading) { return anchorOf(heading) == anchor; }))
                << file << ": " << to << " has no heading #" << anchor;
        }
    }
}

TEST(Citations, NameAHeadingOfADocument) {
    EXPECT_THAT(citations("/// A thing (docs/a.md,\n/// \"One\" and \"Two\").\n"), testing::SizeIs(2));
    int found = 0;
    for (const std::string& file : sources({"core", "transport", "robots", "widgets", "app", "tests"})) {
        if (file.starts_with("tests/architecture/")) continue;
        for (const Citation& one : citations(content(file))) {
            ++found;
            EXPECT_TRUE(headings(one.document).contains(one.heading))
                << file << " cites " << one.document << ", \"" << one.heading << "\"";
        }
    }
    EXPECT_GT(found, 20) << "comments cite the design by its headings";
}

}  // namespace
}  // namespace leitstand::test
