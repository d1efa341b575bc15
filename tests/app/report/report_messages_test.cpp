// What an operator is told of a hand-in, above all of one that is broken.
#include <chrono>
#include <filesystem>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/handin/writing/report_messages.h"
#include "app/services/handin/writing/report_writer.h"
#include "tests/app/report/sample_mission.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr const char* Name = "RoboCup2013-Deutschland1-Final_1";

ReportOutcome outcomeOf(std::vector<ReportFile> files, std::vector<std::string> warnings) {
    ReportOutcome outcome;
    outcome.name = "C-T-M";
    outcome.files = std::move(files);
    outcome.warnings = std::move(warnings);
    return outcome;
}

TEST(ReportMessages, NamesEachBrokenFileAndWhy) {
    const auto reported =
        ReportMessages().of(outcomeOf({{"C-T-M.tif", 9, false, "/out/C-T-M.tif: cannot be opened"},
                                       {"C-T-M_qr.csv", 9, true, "0 rows"},
                                       {"SHA256SUMS", 9, false, "/out/C-T-M.tif: its SHA-256 is another"}},
                                      {"there is no map"}),
                            "/out");
    EXPECT_THAT(reported, ElementsAre("there is no map",
                                      "The report in /out is not whole: C-T-M.tif: cannot be opened; "
                                      "SHA256SUMS: C-T-M.tif: its SHA-256 is another"));
}

TEST(ReportMessages, WhatIsMissingIsToldOnceUntilItChanges) {
    ReportMessages publishing;
    const auto reported = [&](std::vector<std::string> warnings) {
        return publishing.of(outcomeOf({{"C-T-M.tif", 9, true, "a map"}}, std::move(warnings)), "/out");
    };
    EXPECT_THAT(reported({"V1 is not confirmed"}),
                ElementsAre("V1 is not confirmed", "Report written into /out"));
    EXPECT_THAT(reported({"V1 is not confirmed"}), ElementsAre("Report written into /out")) << "every minute";
    EXPECT_THAT(reported({"V1, V2 are not confirmed"}),
                ElementsAre("V1, V2 are not confirmed", "Report written into /out"));
    EXPECT_THAT(reported({}), ElementsAre("Report written into /out"));
    EXPECT_THAT(reported({"V1 is not confirmed"}), Contains("V1 is not confirmed")) << "it is so again";
    EXPECT_THAT(publishing.of(Error{"/out: no space left"}, "/out"), ElementsAre("/out: no space left"));
}

TEST(ReportMessages, APdfThatIsNoneIsToldByItsName) {
    const TemporaryFolder folder;
    writeSampleMission(folder / "final", {.scans = 1});
    ReportOptions options;
    options.pdf = [](const ReportContent&) -> Result<std::string> { return std::string("half a page"); };
    const auto done = writeReport(folder / "final", folder / "out", options);
    ASSERT_TRUE(done) << done.error().text;
    EXPECT_FALSE(done->whole());
    const auto reported = ReportMessages().of(done, folder / "out");
    ASSERT_FALSE(reported.empty());
    EXPECT_THAT(reported.back(),
                AllOf(HasSubstr("The report in " + (folder / "out").string() + " is not whole"),
                      HasSubstr(std::string(Name) + ".pdf: expected %PDF"), Not(HasSubstr(".tif"))));
    EXPECT_THAT(reported, Contains(HasSubstr("not confirmed, so in the map but not in the lists: V2")));
}

// Someone writes into a list of the report while the rest of it is made.
TEST(BrokenReport, IsToldByTheCommandLineAndIsOne) {
    const TemporaryFolder folder;
    writeSampleMission(folder / "final");
    const fs::path list = folder / "out" / (std::string(Name) + "_qr.csv");
    ProcessOutcome made;
    {
        const std::jthread other([&](const std::stop_token& stop) {
            if (waitUntil([&] { return fs::exists(list) || stop.stop_requested(); },
                          std::chrono::minutes(1)) &&
                !stop.stop_requested())
                writeText(list, "no list");
        });
        made = runProcess(program("leitstandctl"),
                          {"report", (folder / "final").string(), "--out", (folder / "out").string()});
    }
    EXPECT_EQ(made.exitCode, 1) << made.out << made.err;
    EXPECT_THAT(made.out, ContainsRegex("_qr\\.csv +[0-9]+ +BROKEN: "));
}

}  // namespace
}  // namespace leitstand::test
