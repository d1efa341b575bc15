// What reaches a terminal, a tooltip or JSON goes through the places that make it harmless.
#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/architecture/sources.h"

namespace leitstand::test {
namespace {

/// Lines of @p text that hold one of @p calls and none of @p excuses, as "FILE:LINE: TEXT".
std::vector<std::string> linesWith(const std::string& file, const std::vector<std::string>& calls,
                                   const std::vector<std::string>& excuses) {
    std::vector<std::string> found;
    const std::string text = content(file);
    std::size_t number = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = text.substr(begin, end - begin);
        begin = end + 1;
        ++number;
        const auto holds = [&](const std::string& word) { return line.find(word) != std::string::npos; };
        if (std::any_of(calls.begin(), calls.end(), holds) &&
            std::none_of(excuses.begin(), excuses.end(), holds))
            found.push_back(fmt::format("{}:{}: {}", file, number, line));
    }
    return found;
}

TEST(Terminal, NothingIsPrintedThatWasNotMadePrintable) {
    for (const std::string& file : sources({"core", "transport", "robots", "widgets", "app"})) {
        if (file == "app/cli/console/output.cpp") continue;  // the place itself
        EXPECT_THAT(linesWith(file,
                              {"fmt::print(", "fprintf(", "std::printf(", "fputs(", "std::cout", "std::cerr",
                               "std::puts(", "perror("},
                              {"printable(", "guardHelp(", "versionOf(", "fputs(\"", "\"\\r\\x1b[K\""}),
                    testing::IsEmpty());
    }
}

TEST(Terminal, JsonHasOneWriter) {
    for (const std::string& file : sources({"core", "transport", "robots", "widgets", "app"})) {
        if (file == "app/cli/console/output.cpp") continue;
        EXPECT_THAT(linesWith(file, {".dump("}, {}), testing::IsEmpty());
    }
}

}  // namespace
}  // namespace leitstand::test
