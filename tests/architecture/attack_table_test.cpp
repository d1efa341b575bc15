// The tables of attacks in the documents, which `packaging/leitstand test --long` writes.
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

/// A document with a table of @p area.
std::string withTable(const std::string& area) {
    return "Before\n\n<!-- attacks:begin " + area +
           ", written by packaging/leitstand test --long -->\n| old |\n<!-- attacks:end -->\nBetween\n";
}

/// Documents of a folder, and what packaging/attack-table.py makes of them.
class AttackTable : public testing::Test {
protected:
    AttackTable() {
        std::filesystem::create_directory(m_docs);
        writeText(m_docs / "log.md", withTable("log"));
        writeText(m_docs / "security.md", withTable("wire") + withTable("pictures"));
    }
    [[nodiscard]] ProcessOutcome write(const std::string& output) const {
        writeText(m_folder / "output", output);
        return runProcess("/usr/bin/env", {"python3", sourceFolder() + "/packaging/attack-table.py",
                                           (m_folder / "output").string(), m_docs.string()});
    }
    const TemporaryFolder m_folder;
    const std::filesystem::path m_docs = m_folder / "docs";
};

TEST_F(AttackTable, HasTheLastThatWasToldOfEachAttackAndLeavesTheRest) {
    const ProcessOutcome written = write(
        "12: ATTACK|wire|one|20000|all live\nsome other output\nATTACK|log|cut|6|read\n"
        "ATTACK|pictures|large|1|refused\nATTACK|wire|two|7|told\n  ATTACK|wire|one|1000000|well\n");
    ASSERT_EQ(written.exitCode, 0) << written.err;
    const std::string head = " -->\n| attack | how often | what happened |\n|---|--:|---|\n";
    const std::string security = readText(m_docs / "security.md");
    EXPECT_THAT(security, HasSubstr("--long" + head +
                                    "| one | 1,000,000 | well |\n| two | 7 | told |\n<!-- attacks:end -->\n"
                                    "Between\nBefore"));
    EXPECT_THAT(security, HasSubstr("--long" + head + "| large | 1 | refused |\n<!-- attacks:end -->"));
    EXPECT_THAT(readText(m_docs / "log.md"), HasSubstr("| cut | 6 | read |\n"));
}

TEST_F(AttackTable, IsNotWrittenWhereAnAreaHasNoPlaceOrNothingIsTold) {
    const std::string all = "ATTACK|wire|a|1|b\nATTACK|log|a|1|b\nATTACK|pictures|a|1|b\n";
    EXPECT_THAT(write(all + "ATTACK|air|a|1|b\n").err, HasSubstr("no document has a table of air"));
    EXPECT_THAT(write("ATTACK|wire|a|1|b\nATTACK|log|a|1|b\n").err, HasSubstr("a table of pictures"));
    EXPECT_THAT(write(all + "ATTACK|wire|a|often|b\n").err, HasSubstr("found \"ATTACK|wire|a|often|b\""));
    EXPECT_EQ(readText(m_docs / "log.md"), withTable("log"));
    EXPECT_EQ(readText(m_docs / "security.md"), withTable("wire") + withTable("pictures"));
}

TEST_F(AttackTable, HasAPlaceForEachAreaInTheDocuments) {
    for (const auto& one : std::filesystem::directory_iterator(sourceFolder() + "/docs")) {
        if (one.path().extension() == ".md")
            std::filesystem::copy_file(one, m_docs / one.path().filename(),
                                       std::filesystem::copy_options::overwrite_existing);
    }
    std::filesystem::remove(m_docs / "log.md");
    const ProcessOutcome written = write("ATTACK|wire|a|1|b\nATTACK|log|a|1|b\nATTACK|pictures|a|1|b\n");
    EXPECT_EQ(written.exitCode, 0) << written.err;
}

}  // namespace
}  // namespace leitstand::test
