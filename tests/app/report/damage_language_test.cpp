// What is wrong with a mission, told in the language of the report.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/report/sample_mission.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// A mission whose log was cut.
class DamageLanguage : public testing::Test {
protected:
    DamageLanguage() {
        writeSampleMission(m_folder / "torn");
        const fs::path log = m_folder / "torn" / "torn_0.db3";
        fs::resize_file(log, fs::file_size(log) * 3 / 4);
    }
    [[nodiscard]] std::string reported(const char* language) const {
        const ProcessOutcome outcome =
            runProcess(program("leitstandctl"), {"report", (m_folder / "torn").string(), "--out",
                                                 (m_folder / language).string(), "--language", language});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.err;
    }

    TemporaryFolder m_folder;
};

TEST_F(DamageLanguage, IsThatOfTheReport) {
    EXPECT_THAT(reported("en"), HasSubstr("read page by page"));
    const std::string german = reported("de"), japanese = reported("ja");
    EXPECT_THAT(german, HasSubstr("Seite für Seite gelesen"));
    EXPECT_THAT(japanese, HasSubstr("ページごとに読み込み"));
    for (const std::string& text : {german, japanese}) {
        for (const char* english : {"expected", "found", "read page", "is not in the log", "missing"})
            EXPECT_THAT(text, Not(HasSubstr(english)));
    }
}

}  // namespace
}  // namespace leitstand::test
