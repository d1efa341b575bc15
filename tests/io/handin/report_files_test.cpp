#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/handin/checksums.h"
#include "core/io/handin/find_lists.h"
#include "core/io/handin/geotiff.h"
#include "core/io/handin/octomap_file.h"
#include "tests/core/handin/report_scene.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

MapPicture roomPicture() {
    MapDrawing drawing;
    drawing.title = "RoboCup2013-Team-Mission.tif";
    drawing.grid = roomGrid(roomScans(2));
    drawing.marks = {{MapMark::Kind::Victim, 7, {1.0, 0.5}}};
    drawing.starts = {{{-1.0, 0.0}, 0.0}};
    return paintMap(drawing);
}

TEST(GeoTiff, IsReadAgainAsItWas) {
    const TemporaryFolder folder;
    const MapPicture map = roomPicture();
    ASSERT_TRUE(writeGeoTiff(folder / "map.tif", map));
    const auto read = readGeoTiff(folder / "map.tif");
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->picture.width, map.picture.width);
    EXPECT_EQ(read->picture.bytes, map.picture.bytes);
    EXPECT_EQ(read->topLeft, map.topLeft);
    EXPECT_DOUBLE_EQ(read->perPixel, map.perPixel);
    ASSERT_TRUE(writeGeoTiff(folder / "again.tif", map));
    EXPECT_EQ(readText(folder / "map.tif"), readText(folder / "again.tif")) << "equal maps, equal bytes";
}

TEST(GeoTiff, GdalinfoSeesAGeoreferencedPicture) {
    const TemporaryFolder folder;
    const MapPicture map = roomPicture();
    ASSERT_TRUE(writeGeoTiff(folder / "map.tif", map));
    const ProcessOutcome info = runProcess("/usr/bin/gdalinfo", {(folder / "map.tif").string()});
    ASSERT_EQ(info.exitCode, 0) << "gdal-bin is missing? " << info.err;
    EXPECT_THAT(info.out, HasSubstr("Pixel Size = (0.010000000000000,-0.010000000000000)"));
    EXPECT_THAT(info.out, HasSubstr("ColorInterp=Red"));
    EXPECT_THAT(info.out, HasSubstr("ColorInterp=Blue"));
    EXPECT_THAT(info.out, HasSubstr("Type=Byte"));
    EXPECT_THAT(info.out, HasSubstr("north is x"));
}

TEST(GeoTiff, BrokenFilesAreErrorsThatNameTheFile) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeGeoTiff(folder / "map.tif", roomPicture()));
    const std::string whole = readText(folder / "map.tif");
    writeText(folder / "cut.tif", whole.substr(0, whole.size() / 2));
    writeText(folder / "text.tif", "not a picture");
    writeText(folder / "empty.tif", "");
    for (const char* name : {"cut.tif", "text.tif", "empty.tif", "absent.tif"}) {
        const auto read = readGeoTiff(folder / name);
        ASSERT_FALSE(read) << name;
        EXPECT_THAT(read.error().text, HasSubstr(name));
    }
    MapPicture none;
    EXPECT_FALSE(writeGeoTiff(folder / "none.tif", none));
    EXPECT_FALSE(writeGeoTiff(folder / "no" / "folder.tif", roomPicture()));
}

FindList pois() {
    return {.kind = FindList::Kind::Pois,
            .team = "Team \"Rot\"",
            .country = "Germany",
            .date = "2026-11-21",
            .time = "20:11:54",
            .mission = "Final 1",
            .finds = {{1, "20:12:33", "V1", {1.5, -0.00001, 0.25}, "kurt3d", "T", "victim"},
                      {2, "20:13:00", "a, \"b\"\nc", {-3.25, 2.0, 0.1}, "crawler", "A", "qr"}}};
}

TEST(FindLists, LookAsTheRulesSay) {
    EXPECT_EQ(textOf(pois()),
              "\"pois\"\n\"1.2\"\n\"Team \"\"Rot\"\"\"\n\"Germany\"\n\"2026-11-21\"\n"
              "\"20:11:54\"\n\"Final 1\"\n\nid,time,text,x,y,z,robot,mode,type\n"
              "1,20:12:33,V1,1.500,0.000,0.250,kurt3d,T,victim\n"
              "2,20:13:00,\"a, \"\"b\"\" c\",-3.250,2.000,0.100,crawler,A,qr\n");
    FindList victims = pois();
    victims.kind = FindList::Kind::Victims;
    EXPECT_THAT(textOf(victims), StartsWith("\"victims\"\n\"1.0\"\n"));
    EXPECT_THAT(textOf(victims), HasSubstr("\n\nid,time,name,x,y,z\n1,20:12:33,V1,1.500,0.000,0.250\n"));
    victims.kind = FindList::Kind::Codes;
    EXPECT_THAT(textOf(victims), StartsWith("\"qr codes\"\n\"1.1\"\n"));
    EXPECT_THAT(textOf(victims), HasSubstr("\n\nid,time,text,x,y,z,robot,mode\n"));
    EXPECT_EQ(endingOf(FindList::Kind::Codes), "_qr.csv");
}

TEST(FindLists, AreReadAgain) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeFindList(folder / "a_pois.csv", pois()));
    const auto read = readFindList(folder / "a_pois.csv");
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->kind, FindList::Kind::Pois);
    EXPECT_EQ(read->team, "Team \"Rot\"");
    EXPECT_EQ(read->mission, "Final 1");
    ASSERT_EQ(read->finds.size(), 2u);
    EXPECT_EQ(read->finds[1].text, "a, \"b\" c");
    EXPECT_EQ(read->finds[1].type, "qr");
    EXPECT_EQ(textOf(*read), readText(folder / "a_pois.csv"));
}

TEST(FindLists, AreReadAgainWhereNobodyToldTeamOrCountry) {
    const TemporaryFolder folder;
    FindList list = pois();
    list.team = list.country = "";
    ASSERT_TRUE(writeFindList(folder / "pois.csv", list));
    const auto read = readFindList(folder / "pois.csv");
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->date, list.date);
    EXPECT_EQ(read->time, list.time);
    EXPECT_EQ(read->mission, list.mission);
    EXPECT_EQ(textOf(*read), textOf(list));
}

TEST(FindLists, OthersFilesAreReadLeniently) {
    const TemporaryFolder folder;
    writeText(folder / "b.csv",
              "\xEF\xBB\xBF"
              "Victims\r\n1.0\r\nTeam\r\nIran\r\n2013-06-30\r\n10:00:00\r\nM\r\n"
              "ID , Time, X, Y, Name\r\n 3 , 10:01:02 , 1e0 , -2, \"Doll\" \r\n\r\n");
    const auto read = readFindList(folder / "b.csv");
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->kind, FindList::Kind::Victims);
    EXPECT_EQ(read->country, "Iran");
    ASSERT_EQ(read->finds.size(), 1u);
    EXPECT_EQ(read->finds[0].text, "Doll");
    EXPECT_EQ(read->finds[0].position, Eigen::Vector3d(1, -2, 0));
}

TEST(FindLists, BrokenOnesAreErrorsWithTheirLine) {
    const TemporaryFolder folder;
    const auto errorOf = [&](const std::string& text) {
        writeText(folder / "c.csv", text);
        const auto read = readFindList(folder / "c.csv");
        return read ? std::string("none") : read.error().text;
    };
    EXPECT_THAT(errorOf("victims\n1.0\n\nid,time,name,x,y,z\n1,a,b,one,2,3\n"),
                testing::AllOf(HasSubstr("c.csv:5"), HasSubstr("a number as x")));
    EXPECT_THAT(errorOf("victims\n1.0\n\nid,time,name,x,y,z\n1,a,b,nan,2,3\n"), HasSubstr("a number as x"));
    EXPECT_THAT(errorOf("victims\n"), HasSubstr("begins with \"id\""));
    EXPECT_THAT(errorOf(""), HasSubstr("c.csv"));
    EXPECT_THAT(errorOf("id,time,name,q,y,z\n"), HasSubstr("column \"x\""));
    EXPECT_THAT(errorOf(std::string(200'000, 'x')), HasSubstr("c.csv"));
    EXPECT_THAT(errorOf("id,time,name,x,y,z\n99999999999999,a,b,1,2,3\n"), HasSubstr("a number as id"));
    FindList broken = pois();
    broken.finds[0].position.x() = std::nan("");
    EXPECT_FALSE(writeFindList(folder / "d.csv", broken));
}

TEST(OctomapFile, HasTheRoomsVolume) {
    const TemporaryFolder folder;
    const VoxelEvidence evidence = VoxelEvidence::of(roomScans(3));
    ASSERT_TRUE(writeOctomap(folder / "room.bt", evidence));
    const auto read = readOctomap(folder / "room.bt");
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_DOUBLE_EQ(read->cell, evidence.cell());
    EXPECT_GT(read->free, 60.0) << "of 8 m x 6 m x 2.6 m = 125 m3";
    EXPECT_LT(read->free, 126.0);
    EXPECT_GT(read->occupied, 2.0);
    EXPECT_LT(read->occupied, 12.0);
    ASSERT_TRUE(writeOctomap(folder / "again.bt", evidence));
    EXPECT_EQ(readText(folder / "room.bt"), readText(folder / "again.bt"));
}

TEST(OctomapFile, OctomapsOwnToolReadsIt) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeOctomap(folder / "room.bt", VoxelEvidence::of(roomScans(1))));
    const ProcessOutcome made = runProcess("/usr/bin/bt2vrml", {(folder / "room.bt").string()});
    EXPECT_EQ(made.exitCode, 0) << "octomap-tools is missing? " << made.err;
    EXPECT_GT(readText(folder / "room.bt.wrl").size(), 10'000u);
}

TEST(OctomapFile, BrokenFilesAreErrors) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeOctomap(folder / "room.bt", VoxelEvidence::of(roomScans(1))));
    const std::string whole = readText(folder / "room.bt");
    writeText(folder / "cut.bt", whole.substr(0, whole.size() / 2));
    writeText(folder / "text.bt", "hello");
    for (const char* name : {"cut.bt", "text.bt", "absent.bt"}) {
        const auto read = readOctomap(folder / name);
        ASSERT_FALSE(read) << name;
        EXPECT_THAT(read.error().text, HasSubstr(name));
    }
}

TEST(Checksums, AreThoseOfSha256sum) {
    const TemporaryFolder folder;
    writeText(folder / "abc.txt", "abc");
    writeText(folder / "empty.txt", "");
    ASSERT_TRUE(writeChecksums(folder.path(), {"abc.txt", "empty.txt"}));
    EXPECT_EQ(readText(folder / "SHA256SUMS"),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad  abc.txt\n"
              "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855  empty.txt\n");
    const auto checked = checkChecksums(folder.path());
    ASSERT_TRUE(checked) << checked.error().text;
    EXPECT_THAT(*checked, ElementsAre("abc.txt", "empty.txt"));
    writeText(folder / "abc.txt", "abd");
    const auto changed = checkChecksums(folder.path());
    ASSERT_FALSE(changed);
    EXPECT_THAT(changed.error().text, HasSubstr("abc.txt"));
    EXPECT_FALSE(writeChecksums(folder.path(), {"absent"}));
}

}  // namespace
}  // namespace leitstand::test
