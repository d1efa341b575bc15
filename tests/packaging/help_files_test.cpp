// Man pages and completions tell what programs tell of themselves.
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/version/version.h"
#include "tests/packaging/told_options.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::IsSupersetOf;

fs::path share() {
    return fs::path(program("leitstandctl")).parent_path().parent_path() / "share";
}

/// Text of roff as people read it.
std::string unescaped(std::string text) {
    for (const auto& [code, plain] : {std::pair<std::string, std::string>("\\-", "-"),
                                      {"\\&", ""},
                                      {"\\e", "\\"},
                                      {"\\(aq", "'"},
                                      {"\\(ga", "`"}}) {
        for (std::size_t at = 0; (at = text.find(code, at)) != std::string::npos; at += plain.size())
            text.replace(at, code.size(), plain);
    }
    return text;
}

/// Options that stand as such in the man page of @p name.
ToldOptions toldByManPage(const std::string& name) {
    static const std::regex heading("\\.SS \"(.*)\""), option("\\\\fB(-[^\\\\]*)\\\\fR");
    ToldOptions reported;
    std::istringstream page(readText(share() / "man/man1" / (name + ".1")));
    std::string words = name, before;
    for (std::string line; std::getline(page, line); before = line) {
        std::smatch found;
        line = unescaped(line);
        if (std::regex_match(line, found, heading)) words = found[1];
        if (before != ".TP") continue;
        for (std::sregex_iterator one(line.begin(), line.end(), option), end; one != end; ++one)
            reported[words].insert((*one)[1].str());
    }
    return reported;
}

/// What bash offers behind @p words where the user has begun to write @p begun.
std::set<std::string> offeredByBash(const std::string& name, const std::string& words,
                                    const std::string& begun) {
    const std::string script = fmt::format(
        "source '{}'; COMP_WORDS=({} '{}'); COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); "
        "_{}; printf '%s\\n' \"${{COMPREPLY[@]}}\"",
        (share() / "bash-completion/completions" / name).string(), words, begun,
        std::regex_replace(name, std::regex("-"), "_"));
    std::istringstream reported(runProcess("/bin/bash", {"--norc", "-c", script}).out);
    std::set<std::string> offered;
    for (std::string line; std::getline(reported, line);) {
        if (!line.empty()) offered.insert(line);
    }
    return offered;
}

class EachProgram : public testing::TestWithParam<std::string> {};

TEST_P(EachProgram, TellsItsVersionAndCommit) {
    const ProcessOutcome reported = runProcess(program(GetParam()), {"--version"});
    EXPECT_EQ(reported.exitCode, 0) << reported.err;
    EXPECT_EQ(reported.out, versionOf(GetParam().c_str()) + "\n");
    EXPECT_TRUE(std::regex_match(reported.out, std::regex("leitstand\\S* \\d+\\.\\d+\\.\\d+( \\([0-9a-f]{12}"
                                                          "(\\+changes)?\\))?\n")))
        << reported.out;
}

TEST_P(EachProgram, HasAManPageThatTellsAllItsOptionsAndNoOthers) {
    const ToldOptions asked = askedForHelp(GetParam());
    ASSERT_THAT(asked, Contains(testing::Key(GetParam())));
    EXPECT_EQ(toldByManPage(GetParam()), asked);
}

TEST_P(EachProgram, IsCompletedByBash) {
    for (const auto& [words, options] : askedForHelp(GetParam())) {
        EXPECT_THAT(offeredByBash(GetParam(), words, "-"), testing::ContainerEq(options)) << words;
        const std::set<std::string> below = commandsBelow(words);
        EXPECT_THAT(offeredByBash(GetParam(), words, ""), IsSupersetOf(below)) << words;
    }
}

TEST_P(EachProgram, HasACompletionForZsh) {
    const std::string text = readText(share() / "zsh/vendor-completions" / ("_" + GetParam()));
    EXPECT_EQ(text.rfind("#compdef " + GetParam() + "\n", 0), 0U);
    for (const auto& [words, options] : askedForHelp(GetParam())) {
        for (const std::string& option : options) EXPECT_THAT(text, HasSubstr(option + "[")) << words;
    }
}

INSTANTIATE_TEST_SUITE_P(Installed, EachProgram, testing::ValuesIn(programs()), [](const auto& info) {
    return std::regex_replace(info.param, std::regex("-"), "_");
});

TEST(BashCompletion, OffersTheValuesThatHelpLists) {
    EXPECT_THAT(offeredByBash("leitstandctl", "leitstandctl register --minimizer", ""),
                testing::UnorderedElementsAre("dual-quaternion", "gicp", "orthonormal", "plane", "quaternion",
                                              "svd"));
    EXPECT_THAT(offeredByBash("leitstandctl", "leitstandctl report --language", "d"),
                testing::ElementsAre("de"));
    EXPECT_THAT(offeredByBash("leitstand", "leitstand --look", ""),
                testing::UnorderedElementsAre("points", "voxels", "top"));
}

TEST(BashCompletion, FollowsSubcommandsOfSubcommands) {
    EXPECT_THAT(offeredByBash("leitstandctl", "leitstandctl keys", "sh"), testing::ElementsAre("show"));
    EXPECT_THAT(offeredByBash("leitstandctl", "leitstandctl keys show", "--j"),
                testing::ElementsAre("--json"));
}

TEST(BashCompletion, OffersNothingOfItsOwnWhereAFileIsWanted) {
    EXPECT_THAT(offeredByBash("leitstandctl", "leitstandctl record --out", "--"), testing::IsEmpty());
}

}  // namespace
}  // namespace leitstand::test
