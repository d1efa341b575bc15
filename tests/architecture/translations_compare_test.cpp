// packaging/translations-compare on two files that are made up.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/missing_tool.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string message(const std::string& source, const std::string& translation) {
    return "<message><source>" + source + "</source>" + translation + "</message>\n";
}

std::string translated(const std::string& source, const std::string& translation) {
    return message(source, "<translation>" + translation + "</translation>");
}

std::string tsFile(const std::string& language, const std::string& context, const std::string& messages) {
    return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<!DOCTYPE TS>\n<TS version=\"2.1\" language=\"" +
           language + "\">\n<context>\n<name>" + context + "</name>\n" + messages + "</context>\n</TS>\n";
}

/// A checkout with a German and a Japanese file, which are committed.
class TranslationsCompare : public testing::Test {
protected:
    void SetUp() override {
        if (runProcess("/usr/bin/env", {"git", "--version"}).exitCode != 0) LEITSTAND_MISSING_TOOL("git");
        std::filesystem::create_directories(m_folder / "translations");
        std::filesystem::create_directories(m_folder / "tests/compat");
        write("de", "Old", m_german);
        write("ja", "Old", translated("Stop", "停止"));
        for (const std::vector<std::string>& step : {std::vector<std::string>{"init", "-q"},
                                                     {"add", "translations"},
                                                     {"commit", "-q", "-m", "before"}})
            EXPECT_EQ(git(step).exitCode, 0) << git(step).err;
    }
    void write(const std::string& language, const std::string& context, const std::string& messages) const {
        writeText(m_folder / ("translations/leitstand_" + language + ".ts"),
                  tsFile(language, context, messages));
    }
    [[nodiscard]] ProcessOutcome git(std::vector<std::string> arguments) const {
        std::vector<std::string> all = {
            "git", "-C", m_folder.path().string(), "-c", "user.name=test", "-c", "user.email=test@test"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        return runProcess("/usr/bin/env", all);
    }
    [[nodiscard]] ProcessOutcome compare(const std::string& ref = "HEAD") const {
        return runProcess("/usr/bin/env", {"python3", sourceFolder() + "/packaging/translations-compare",
                                           "--root", m_folder.path().string(), ref});
    }

    const std::string m_german =
        translated("Stop", "Halt") + translated("Drive", "Fahren") +
        message("%n robots",
                "<translation><numerusform>%n Roboter</numerusform><numerusform>%n Robotern"
                "</numerusform></translation>") +
        message("New", "<translation type=\"unfinished\"></translation>");
    const TemporaryFolder m_folder;
};

TEST_F(TranslationsCompare, AnotherContextAndNewTextsAreNoLoss) {
    EXPECT_EQ(compare().exitCode, 0);
    write("de", "Renamed", m_german + translated("More", "Mehr"));
    const ProcessOutcome outcome = compare();
    EXPECT_EQ(outcome.exitCode, 0) << outcome.out;
    EXPECT_THAT(outcome.out, HasSubstr("4 pairs of HEAD, 0 lost or changed"));
}

TEST_F(TranslationsCompare, NamesWhatIsLostAndWhatChanged) {
    write("de", "Old",
          translated("Stop", "Anhalten") + translated("Drive", "Fahren") +
              message("%n robots",
                      "<translation type=\"unfinished\"><numerusform></numerusform></translation>"));
    std::filesystem::remove(m_folder / "translations/leitstand_ja.ts");
    const ProcessOutcome outcome = compare();
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("de: \"Stop\": \"Halt\" became \"Anhalten\"\n"),
                                   HasSubstr("de: \"%n robots\": \"%n Roboter | %n Robotern\" is lost\n"),
                                   HasSubstr("ja: \"Stop\": \"停止\" is lost\n"),
                                   HasSubstr("3 lost or changed"), Not(HasSubstr("Drive"))));
}

TEST_F(TranslationsCompare, WhatWasMeantToChangeMay) {
    write("de", "Old", translated("Stop", "Anhalten") + translated("Drive", "Los"));
    writeText(m_folder / "tests/compat/changed-texts.txt", "# meant\nde: Stop\n*: %n robots\nja: Drive\n");
    const ProcessOutcome outcome = compare();
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.out,
                AllOf(HasSubstr("de: \"Drive\": \"Fahren\" became \"Los\""), HasSubstr("1 lost or changed")));
}

TEST_F(TranslationsCompare, WhatCannotBeReadIsTold) {
    EXPECT_EQ(compare("nowhere").exitCode, 2);
    EXPECT_THAT(compare("nowhere").err, HasSubstr("nowhere"));
    writeText(m_folder / "translations/leitstand_de.ts", "<TS>");
    const ProcessOutcome outcome = compare();
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_THAT(outcome.err, HasSubstr("leitstand_de.ts: expected a .ts file"));
}

}  // namespace
}  // namespace leitstand::test
