// The table of docs/security.md that `packaging/leitstand fuzz --all` writes.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

class FuzzTable : public testing::Test {
protected:
    [[nodiscard]] ProcessOutcome write(const std::string& document) const {
        writeText(m_folder / "table.tsv", "pad\t1200000\t600\t321\t0\nbag\t34000\t601\t5000\t1\n");
        writeText(m_folder / "document.md", document);
        return runProcess("/usr/bin/env",
                          {"python3", sourceFolder() + "/packaging/fuzz-table.py",
                           (m_folder / "table.tsv").string(), (m_folder / "document.md").string()});
    }
    [[nodiscard]] std::string document() const { return readText(m_folder / "document.md"); }

    const TemporaryFolder m_folder;
};

TEST_F(FuzzTable, StandsBetweenItsMarksAsOftenAsItIsWritten) {
    const std::string security = readText(sourceFolder() + "/docs/security.md");
    ASSERT_EQ(write(security).exitCode, 0);
    const std::string once = document();
    EXPECT_THAT(once,
                HasSubstr("| `bag` | 34,000 | 601 | 5,000 | 1 |\n| `pad` | 1,200,000 | 600 | 321 | 0 |\n"
                          "| 2 targets | 1,234,000 | 1,201 | | 1 |\n<!-- fuzz:end -->"));
    ASSERT_EQ(write(once).exitCode, 0);
    EXPECT_EQ(document(), once);
}

TEST_F(FuzzTable, NeedsItsMarks) {
    const ProcessOutcome outcome = write("no marks\n");
    EXPECT_NE(outcome.exitCode, 0);
    EXPECT_THAT(outcome.err, HasSubstr("document.md: expected"));
    EXPECT_EQ(document(), "no marks\n");
}

}  // namespace
}  // namespace leitstand::test
