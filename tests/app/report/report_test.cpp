#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/handin/writing/report_files.h"
#include "core/io/bag/bag_writer.h"
#include "core/io/clouds/tum.h"
#include "core/io/handin/find_lists.h"
#include "core/io/handin/geotiff.h"
#include "core/io/handin/search_list.h"
#include "core/mission/state/find_state.h"
#include "tests/app/report/sample_mission.h"
#include "tests/support/pdf_pictures.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* Name = "RoboCup2013-Deutschland1-Final_1";

ProcessOutcome ctl(std::vector<std::string> arguments) {
    return runProcess(program("leitstandctl"), arguments);
}

Rgb at(const MapPicture& map, double x, double y) {
    const Eigen::Vector2d pixel = map.pixelOf({x, y});
    return map.at(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
}

std::string pdfText(const fs::path& file) {
    const ProcessOutcome text = runProcess("/usr/bin/pdftotext", {"-layout", file.string(), "-"});
    EXPECT_EQ(text.exitCode, 0) << "poppler-utils is missing? " << text.err;
    return text.out;
}

/// One mission and its report, for all tests: both are only read.
class Report : public testing::Test {
protected:
    static void SetUpTestSuite() {
        s_folder = std::make_unique<TemporaryFolder>();
        writeSampleMission(*s_folder / "final");
        s_outcome = ctl({"report", mission(), "--out", out().string(), "--json"});
    }
    static void TearDownTestSuite() { s_folder.reset(); }
    static std::string mission() { return (*s_folder / "final").string(); }
    static fs::path out() { return *s_folder / "out"; }
    static fs::path file(const std::string& ending) { return out() / (Name + ending); }

    static std::unique_ptr<TemporaryFolder> s_folder;
    static ProcessOutcome s_outcome;
};
std::unique_ptr<TemporaryFolder> Report::s_folder;
ProcessOutcome Report::s_outcome;

TEST_F(Report, HasAllFilesAndHasReadThemAgain) {
    ASSERT_EQ(s_outcome.exitCode, 0) << s_outcome.err;
    const auto json = nlohmann::json::parse(s_outcome.out);
    EXPECT_EQ(json["name"], Name);
    EXPECT_EQ(json["victims"], 1);
    EXPECT_EQ(json["finds"], 5) << "one is discarded";
    EXPECT_EQ(json["scans"], 3);
    for (const auto& one : json["files"]) EXPECT_TRUE(one["whole"].get<bool>()) << one;
    for (const char* ending :
         {".tif", "_upper.tif", "_victims.csv", "_qr.csv", "_pois.csv", ".bt", ".ply", "_kurt3d.tum", ".pdf"})
        EXPECT_TRUE(fs::exists(file(ending))) << ending;
    EXPECT_THAT(s_outcome.err, AllOf(HasSubstr("not confirmed, so in the map but not in the lists: V2"),
                                     HasSubstr("V1: its picture is missing")));
    EXPECT_LT(json["seconds"], 60.0);
    std::printf("a report of 3 scans takes %.2f s\n", json["seconds"].get<double>());
}

TEST_F(Report, OfAMapWithTwoStoreysHasBoth) {
    const TemporaryFolder folder;
    SampleMission what;
    what.scans = 5;
    what.upstairs = true;
    writeSampleMission(folder / "two", what);
    const fs::path made = folder / "out";
    const ProcessOutcome reported = ctl({"report", (folder / "two").string(), "--out", made.string()});
    ASSERT_EQ(reported.exitCode, 0) << reported.err;
    const auto map = [&](const std::string& ending) { return readGeoTiff(made / (Name + ending)).value(); };
    const MapPicture below = map("_storey0.tif"), above = map("_storey1.tif");
    EXPECT_EQ(at(below, 1.5 + 0.14, 1.0), map_colour::Victim) << "V1";
    EXPECT_EQ(at(above, 1.5, 1.0), map_colour::Code) << "Q2, at the same place upstairs";
    EXPECT_EQ(at(above, 2.5 + 0.14, 1.5), map_colour::Victim) << "V4";
    EXPECT_NE(at(below, 2.5 + 0.14, 1.5), map_colour::Victim);
    EXPECT_EQ(at(map(".tif"), 2.5 + 0.14, 1.5), map_colour::Victim) << "the rules' map has everything";
    EXPECT_TRUE(fs::exists(made / (std::string(Name) + "_storey1_upper.tif")));
    const auto rows = readSearchList(made / (std::string(Name) + "_searched.csv")).value();
    EXPECT_TRUE(std::any_of(rows.begin(), rows.end(), [](const ListedSearch& row) {
        return row.what == "seen" && row.storey == 1 && row.area > 5.0;
    }));
    const std::string pdf = pdfText(made / (std::string(Name) + ".pdf"));
    EXPECT_THAT(pdf, HasSubstr("storey +1, map at 0.25 to 0.35 m above its floor"));
    EXPECT_THAT(pdf, HasSubstr("Of the finds, by storey: storey 0: "));
    const auto exported = [&](const char* storey) {
        return ctl(
            {"export", (folder / "two").string(), "--out", (folder / "up.tif").string(), "--storey", storey});
    };
    EXPECT_EQ(exported("1").exitCode, 0);
    EXPECT_EQ(at(readGeoTiff(folder / "up.tif").value(), 1.5, 1.0), map_colour::Code);
    const ProcessOutcome none = exported("2");
    EXPECT_EQ(none.exitCode, 1);
    EXPECT_THAT(none.err, HasSubstr("expected one of the storeys 0, 1, found 2"));
}

TEST_F(Report, ChecksumsAreTrue) {
    const ProcessOutcome sums =
        runProcess("/bin/sh", {"-c", "cd '" + out().string() + "' && sha256sum --check --strict SHA256SUMS"});
    EXPECT_EQ(sums.exitCode, 0) << sums.err << sums.out;
}

TEST_F(Report, TheMapShowsTheRoomAndWhatWasFound) {
    const auto map = readGeoTiff(file(".tif"));
    ASSERT_TRUE(map) << map.error().text;
    EXPECT_EQ(at(*map, 1.5 + 0.14, 1.0), map_colour::Victim);
    EXPECT_EQ(at(*map, -2.0, -1.5), map_colour::UnconfirmedVictim);
    EXPECT_EQ(at(*map, 2.5 + 0.17, -1.0), map_colour::Hazard);
    EXPECT_EQ(at(*map, 0.5, -2.5), map_colour::Code);
    EXPECT_EQ(at(*map, -1.0, 2.0), map_colour::Object);
    const auto upper = readGeoTiff(file("_upper.tif"));
    ASSERT_TRUE(upper) << upper.error().text;
    for (const auto* one : {&*map, &*upper}) {
        int walls = 0;
        for (double x = -1.5; x < 1.5; x += 0.05)
            walls += at(*one, x, -2.98) == map_colour::Wall || at(*one, x, -3.02) == map_colour::Wall ? 1 : 0;
        EXPECT_GT(walls, 40);
    }
}

TEST_F(Report, ListsHaveWhatIsConfirmed) {
    const auto victims = readFindList(file("_victims.csv")), codes = readFindList(file("_qr.csv")),
               pois = readFindList(file("_pois.csv"));
    ASSERT_TRUE(victims.ok() && codes.ok() && pois.ok());
    ASSERT_EQ(victims->finds.size(), 1u);
    EXPECT_EQ(victims->finds[0].text, "V1");
    EXPECT_EQ(victims->finds[0].position, Eigen::Vector3d(1.5, 1.0, 0.4));
    EXPECT_EQ(victims->team, "Deutschland1");
    EXPECT_EQ(victims->mission, "Final 1");
    ASSERT_EQ(codes->finds.size(), 1u);
    EXPECT_EQ(codes->finds[0].text, "exit, \"left\"");
    ASSERT_EQ(pois->finds.size(), 4u);
    EXPECT_EQ(pois->finds[0].mode, "A");
    EXPECT_EQ(pois->finds[1].type, "hazmat");
    EXPECT_EQ(pois->finds[3].text, "valve");
}

TEST_F(Report, TheTrajectoryIsOdometryPutIntoTheMap) {
    const auto way = readTum(file("_kurt3d.tum"));
    ASSERT_TRUE(way) << way.error().text;
    EXPECT_GT(way->size(), 20u);
    for (const TimedPose& pose : *way) EXPECT_NEAR(pose.pose.translation().y(), 0.0, 0.1);
    EXPECT_NEAR(way->front().pose.translation().x(), -1.0, 0.1);
}

TEST_F(Report, ThePdfTellsAllOfIt) {
    const std::string text = pdfText(file(".pdf"));
    for (const char* words : {"RoboCup2013",
                              "Deutschland1",
                              "Germany",
                              "Final 1",
                              "Leitstand test on Sample",
                              "kurt3d",
                              "V1",
                              "V2",
                              "H1",
                              "Q1",
                              "O1",
                              "confirmed",
                              "not confirmed",
                              "whole body",
                              "waving",
                              "36.4 \u00B0C",
                              "1210 ppm",
                              "trapped",
                              "N17",
                              "orange",
                              "under a table <left> & cold",
                              "A (autonomous)",
                              "The way to V1",
                              "along the driven trail",
                              "On the robots: kurt3d drove by itself for",
                              "scans registered into this map while robots",
                              "By people:",
                              "finds filed:",
                              "0.25 to 0.35 m above the floor",
                              "36.0",
                              "CO\u2082 [ppm]",
                              "CO\u2082 measured by kurt3d",
                              "time of day",
                              "scan of kurt3d",
                              "kurt3d stood at x -0.50, y 0.00 m, heading 0",
                              "Report made",
                              "Profile 2005",
                              "version 1.0",
                              "weights of"})
        EXPECT_THAT(text, HasSubstr(words));
    EXPECT_THAT(text, Not(HasSubstr("V3"))) << "discarded";
}

TEST_F(Report, ThePdfHasItsPicturesAndMapPages) {
    std::multiset<std::string> sizes;
    for (const PdfPicture& one : pdfPictures(file(".pdf"))) {
        sizes.insert(fmt::format("{}x{}", one.width, one.height));
        EXPECT_NEAR(one.acrossPerInch, one.downPerInch, 1) << one.width << " x " << one.height;
    }
    // Of V1 a picture of the camera, one of the infrared camera, the scan from above; a way for each find;
    // two maps.
    EXPECT_EQ(sizes.count("160x120"), 1U);
    EXPECT_EQ(sizes.count("80x60"), 1U);
    EXPECT_EQ(sizes.count("560x560"), 1U);
    EXPECT_EQ(sizes.size(), 3U + 5U + 2U);
    const std::string text = pdfText(file(".pdf"));
    std::size_t maps = 0;
    std::istringstream pages(text);
    for (std::string page; std::getline(pages, page, '\f');)
        maps += page.find(fmt::format("{}: map at ", Name)) != std::string::npos ? 1 : 0;
    EXPECT_EQ(maps, 2U) << "a page for each height";
}

TEST_F(Report, TheSameMissionMakesTheSameBytes) {
    const auto at = [](const char* seconds, const fs::path& folder) {
        const ProcessOutcome made =
            runProcess("/usr/bin/env", {std::string("SOURCE_DATE_EPOCH=") + seconds, program("leitstandctl"),
                                        "report", mission(), "--out", folder.string()});
        EXPECT_EQ(made.exitCode, 0) << made.err;
    };
    const fs::path second = *s_folder / "again", third = *s_folder / "and_again";
    at("1700000000", second);
    at("1700000000", third);
    for (const auto& entry : fs::directory_iterator(out())) {
        const std::string name = entry.path().filename().string();
        const std::string again = readText(second / name);
        EXPECT_TRUE(again == readText(third / name)) << name;
        const bool timed = entry.path().extension() == ".pdf" || name == "SHA256SUMS";  // that has the PDF's
        EXPECT_TRUE(timed || readText(entry.path()) == again) << name;
    }
    EXPECT_THAT(readText(second / (std::string(Name) + ".pdf")), HasSubstr("/CreationDate (D:202311"));
}

TEST_F(Report, WrongUseIsTwoAndFailuresAreOne) {
    EXPECT_EQ(ctl({"report", mission()}).exitCode, 2);
    EXPECT_EQ(ctl({"export", mission(), "--out", "map.doc"}).exitCode, 2);
    EXPECT_EQ(ctl({"report", "--help"}).exitCode, 0);
    const ProcessOutcome absent =
        ctl({"report", (*s_folder / "absent").string(), "--out", (*s_folder / "o").string()});
    EXPECT_EQ(absent.exitCode, 1);
    EXPECT_THAT(absent.err, HasSubstr("absent"));
    const ProcessOutcome nobody =
        ctl({"export", mission(), "--out", (*s_folder / "n.tum").string(), "--robot", "nobody"});
    EXPECT_EQ(nobody.exitCode, 1);
    EXPECT_THAT(nobody.err, HasSubstr("nobody"));
    writeText(*s_folder / "afile", "");
    EXPECT_EQ(ctl({"report", mission(), "--out", (*s_folder / "afile").string()}).exitCode, 1);
}

TEST(ShippedSample, IsSmallAndReportedWhole) {
    const fs::path sample = fs::path(sourceFolder()) / "resources/samples/yellow-7";
    std::uintmax_t bytes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(sample)) {
        if (entry.is_regular_file()) bytes += entry.file_size();
    }
    EXPECT_LE(bytes, 5'000'000U);
    const TemporaryFolder folder;
    const ProcessOutcome outcome = ctl({"report", sample.string(), "--out", (folder / "out").string()});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("1 confirmed victims of 3 finds"));
    EXPECT_THAT(pdfText(folder / "out" / "RoboCup2026-Leitstand-Sample.pdf"), HasSubstr("V1"));
}

TEST(ShippedSample, IsReportedInTheLanguageThatIsAskedFor) {
    const fs::path sample = fs::path(sourceFolder()) / "resources/samples/yellow-7";
    const TemporaryFolder folder;
    const auto report = [&](const std::string& language) {
        return ctl(
            {"report", sample.string(), "--out", (folder / language).string(), "--language", language});
    };
    const ProcessOutcome german = report("de");
    EXPECT_EQ(german.exitCode, 0) << german.err;
    EXPECT_THAT(pdfText(folder / "de" / "RoboCup2026-Leitstand-Sample.pdf"),
                AllOf(HasSubstr("Opfer"), HasSubstr("0,25"), Not(HasSubstr("confirmed"))));
    const ProcessOutcome unknown = report("xx");
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_THAT(unknown.err, HasSubstr("--language"));
}

TEST(ShippedSample, TellsWhatWasSearchedAndWhatWasMissed) {
    const fs::path sample = fs::path(sourceFolder()) / "resources/samples/yellow-7";
    const TemporaryFolder folder;
    const ProcessOutcome outcome = ctl({"report", sample.string(), "--out", (folder / "out").string()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto rows = readSearchList(folder / "out" / "RoboCup2026-Leitstand-Sample_searched.csv");
    ASSERT_TRUE(rows) << rows.error().text;
    std::map<std::string, double> seen;
    double reachable = 0.0;
    for (const ListedSearch& row : *rows) {
        if (row.what == "reachable") reachable = row.area;
        if (row.what == "seen") seen[row.sensor] = row.area;
    }
    EXPECT_GT(reachable, 5.0);
    for (const char* sensor : {"scanner", "camera", "infrared"}) {
        EXPECT_GT(seen[sensor], 0.5) << sensor;
        EXPECT_LT(seen[sensor], reachable) << sensor;
    }
    const auto map = readGeoTiff(folder / "out" / "RoboCup2026-Leitstand-Sample.tif");
    ASSERT_TRUE(map) << map.error().text;
    std::size_t cleared = 0, explored = 0;
    for (int row = 0; row < map->picture.height; ++row) {
        for (int column = 0; column < map->picture.width; ++column) {
            const Rgb colour = map->at(column, row);
            cleared += colour.green == 230 && colour.red == colour.blue && colour.red <= 180 ? 1 : 0;
            const bool grey = colour.green == colour.red && colour.red == colour.blue;
            explored += grey && colour.red < 255 ? 1 : 0;  // white are the victims' numbers
        }
    }
    EXPECT_GT(cleared, 5000U) << "half a square metre, in pixels of a centimetre";
    EXPECT_GT(explored, 5000U) << "and floor that nobody looked at";
    EXPECT_THAT(pdfText(folder / "out" / "RoboCup2026-Leitstand-Sample.pdf"),
                AllOf(HasSubstr("Searched"), HasSubstr("Infrared")));
}

TEST(ReportOfLittle, AnEmptyMissionSaysWhatIsMissing) {
    const TemporaryFolder folder;
    writeSampleMission(folder / "empty", {.scans = 0, .odometry = 0, .finds = false, .info = false});
    const ProcessOutcome outcome =
        ctl({"report", (folder / "empty").string(), "--out", (folder / "out").string()});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("there is no map"), HasSubstr("competition or team")));
    EXPECT_THAT(pdfText(folder / "out" / "Competition-Team-empty.pdf"), HasSubstr("Nothing was filed"));
    for (const char* ending : {".bt", ".ply", ".tif", "_upper.tif"})
        EXPECT_FALSE(fs::exists(folder / "out" / ("Competition-Team-empty" + std::string(ending)))) << ending;
    EXPECT_THAT(outcome.err, HasSubstr("without a map there are no GeoTIFF, OctoMap, PLY"));
    const ProcessOutcome german =
        ctl({"report", (folder / "empty").string(), "--out", (folder / "out").string(), "--language", "de"});
    EXPECT_THAT(german.err, AllOf(HasSubstr("es gibt keine Karte"), Not(HasSubstr("there is no map"))));
}

TEST(ReportOfLittle, AMissionWithoutAnyEventSaysSo) {
    const TemporaryFolder folder;
    {
        auto writer = BagWriter::open(folder / "none");
        ASSERT_TRUE(writer) << writer.error().text;
        ASSERT_TRUE((*writer)->close());
    }
    const ProcessOutcome outcome =
        ctl({"report", (folder / "none").string(), "--out", (folder / "out").string()});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("the mission holds no events"));
    const auto victims = readFindList(folder / "out" / "Competition-Team-none_victims.csv");
    ASSERT_TRUE(victims) << victims.error().text;
    EXPECT_EQ(victims->date, "") << "nobody knows when it was";
    EXPECT_EQ(victims->time, "");
}

TEST(ReportOfLittle, WhatTheOperatorRejectedIsNotRegisteredAgain) {
    const TemporaryFolder folder;
    writeSampleMission(folder / "rejected", {.setAside = true});
    const ProcessOutcome outcome =
        ctl({"report", (folder / "rejected").string(), "--out", (folder / "out").string(), "--no-pdf"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("there is no map: all scans of the mission were set aside"),
                                   Not(HasSubstr("no station made a map"))));
    EXPECT_FALSE(fs::exists(folder / "out" / (std::string(Name) + ".ply")));
}

TEST(ReportOfLittle, ADamagedMissionIsReportedAsFarAsItGoes) {
    const TemporaryFolder folder;
    writeSampleMission(folder / "torn");
    const fs::path log = folder / "torn" / "torn_0.db3";
    const auto size = fs::file_size(log);
    fs::resize_file(log, size * 3 / 4);
    const ProcessOutcome outcome =
        ctl({"report", (folder / "torn").string(), "--out", (folder / "out").string()});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("torn_0.db3"));
    std::set<std::string> endings;
    for (const auto& entry : fs::directory_iterator(folder / "out")) {
        const std::string name = entry.path().filename().string();
        endings.insert(name.substr(std::min(name.size(), name.find_first_of("_.", name.rfind('-') + 1))));
        const auto check = checkFile(entry.path());
        EXPECT_TRUE(check.ok()) << check.error().text;
    }
    EXPECT_GE(endings.size(), 7U);
    for (const char* name : {"tif", "csv", "pdf"}) {
        EXPECT_TRUE(std::any_of(endings.begin(), endings.end(),
                                [&](const std::string& ending) { return ending.ends_with(name); }))
            << name << " is made of what is left";
    }
    EXPECT_TRUE(fs::exists(folder / "out" / "SHA256SUMS"));
    writeText(log, "no database");
    const ProcessOutcome nothing =
        ctl({"report", (folder / "torn").string(), "--out", (folder / "out2").string()});
    EXPECT_NE(nothing.err, "") << "an error, or the warning that nothing is left";
    EXPECT_TRUE(nothing.exitCode == 0 || nothing.exitCode == 1) << "it ended by itself";
    EXPECT_EQ(fs::exists(folder / "out2" / "SHA256SUMS"), nothing.exitCode == 0)
        << "a report is whole, or there is none";
}

}  // namespace
}  // namespace leitstand::test
