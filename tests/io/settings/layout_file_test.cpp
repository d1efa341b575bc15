#include "core/io/settings/layout_file.h"

#include <fstream>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/settings/folders.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string errorOf(const std::string& text) {
    const auto layout = parseLayout(text, "mine.yaml");
    return layout ? std::string() : layout.error().text;
}

constexpr const char* Good = R"(
title: Second screen
panes:
  vertical:
    - share: 3
      horizontal: [{pane: camera, share: 2}, {pane: map}]
    - {pane: strip}
arrangement: AAAA/wAAAAD9
keys:
  view.swap: Ctrl+X
  robot.drive:
pad: {a: camera.recentre}
)";

TEST(LayoutFile, TellsPlacesKeysAndPad) {
    const auto layout = parseLayout(Good, "folder/mine.yaml");
    ASSERT_TRUE(layout) << layout.error().text;
    EXPECT_EQ(layout->name, "mine");
    EXPECT_EQ(layout->title, "Second screen");
    EXPECT_TRUE(layout->panes.vertical);
    ASSERT_EQ(layout->panes.parts.size(), 2U);
    EXPECT_EQ(layout->panes.parts[0].share, 3.0);
    EXPECT_FALSE(layout->panes.parts[0].vertical);
    EXPECT_EQ(layout->panes.parts[0].parts[0].share, 2.0);
    EXPECT_THAT(panesIn(layout->panes), ElementsAre("camera", "map", "strip"));
    EXPECT_EQ(layout->keys.at("view.swap"), "Ctrl+X");
    EXPECT_EQ(layout->keys.at("robot.drive"), "") << "a command that has no key";
    EXPECT_EQ(layout->pad.at("a"), "camera.recentre");
}

TEST(LayoutFile, ComesBackAsItWasWritten) {
    const WindowLayout before = parseLayout(Good, "mine.yaml").value();
    const auto after = parseLayout(writeLayout(before), "mine.yaml");
    ASSERT_TRUE(after) << after.error().text;
    EXPECT_EQ(writeLayout(*after), writeLayout(before));
    EXPECT_EQ(after->arrangement, before.arrangement);
    EXPECT_EQ(after->panes.parts[0].share, 3.0);
}

TEST(LayoutFile, ErrorsTellFileLineAndWhatWasExpected) {
    EXPECT_THAT(errorOf("title: A\n"), HasSubstr("panes"));
    EXPECT_THAT(errorOf("panes:\n  pane: camera\n  vertical: []\n"),
                HasSubstr("mine.yaml:1: panes: expected one of"));
    EXPECT_THAT(errorOf("panes:\n  vertical:\n    - {pane: map}\n"), HasSubstr("a list of 2 to 16"));
    EXPECT_THAT(errorOf("panes:\n  vertical: [{pane: map}, {pane: map}]\n"), HasSubstr("already"));
    EXPECT_THAT(errorOf("panes: {pane: map, share: .nan}\n"), HasSubstr("share"));
    EXPECT_THAT(errorOf("panes: {pane: map, share: 0}\n"), HasSubstr("share"));
    EXPECT_THAT(errorOf("panes: {pane: \"../map\"}\n"), HasSubstr("letters, digits"));
    EXPECT_THAT(errorOf("panes: {pane: map}\nkey: {}\n"), HasSubstr("did you mean"));
    EXPECT_THAT(errorOf("panes: {pane: map}\nkeys: {a: [1]}\n"), HasSubstr("a command or button"));
    EXPECT_THAT(errorOf("panes: {pane: map}\nkeys: 3\n"), HasSubstr("keys"));
}

TEST(LayoutFile, TellsHowTheMapIsLookedAt) {
    const auto mapOf = [](const std::string& line) {
        const auto layout = parseLayout("panes: {pane: map}\n" + line, "mine.yaml");
        EXPECT_TRUE(layout) << layout.error().text;
        return layout->map;
    };
    const LayoutMap whole = mapOf("map: {look: top, follow: heading-up}\n");
    EXPECT_EQ(whole.look, MapLook::Top);
    EXPECT_EQ(whole.follow, MapFollow::Above);
    const LayoutMap half = mapOf("map: {follow: behind}\n");
    EXPECT_EQ(half.look, std::nullopt) << "what is left out is the operator's own";
    EXPECT_EQ(half.follow, MapFollow::Behind);
    EXPECT_EQ(mapOf("map: {look: voxels}\n").look, MapLook::Voxels);
    EXPECT_FALSE(mapOf("").isMeaningful());
    EXPECT_FALSE(mapOf("map: {}\n").isMeaningful());
}

TEST(LayoutFile, HowTheMapIsLookedAtComesBackAsItWasWritten) {
    WindowLayout before = parseLayout(Good, "mine.yaml").value();
    EXPECT_EQ(writeLayout(before).find("map: {"), std::string::npos) << "it says nothing";
    for (const MapLook look : {MapLook::Points, MapLook::Voxels, MapLook::Top}) {
        for (const MapFollow follow : {MapFollow::Free, MapFollow::Behind, MapFollow::Above}) {
            before.map = {look, follow};
            const auto after = parseLayout(writeLayout(before), "mine.yaml");
            ASSERT_TRUE(after) << after.error().text;
            EXPECT_EQ(after->map.look, look);
            EXPECT_EQ(after->map.follow, follow);
        }
    }
}

TEST(LayoutFile, ErrorsOfTheMapTellLineKeyAndTheWordsThatThereAre) {
    const std::string panes = "panes: {pane: map}\n";
    EXPECT_THAT(errorOf(panes + "map:\n  look: topp\n"),
                HasSubstr("mine.yaml:3: map.look: expected points, voxels or top, found \"topp\""));
    EXPECT_THAT(errorOf(panes + "map: {follow: above}\n"),
                HasSubstr("mine.yaml:2: map.follow: expected free, behind or heading-up, found \"above\""));
    EXPECT_THAT(errorOf(panes + "map: {look: [top]}\n"),
                HasSubstr("map.look: expected points, voxels or top"));
    EXPECT_THAT(errorOf(panes + "map: top\n"), HasSubstr("mine.yaml:2: map: expected keys and values"));
    EXPECT_THAT(errorOf(panes + "map: [top]\n"), HasSubstr("map: expected keys and values"));
    EXPECT_THAT(errorOf(panes + "map: {folow: free}\n"), HasSubstr("did you mean"));
}

TEST(LayoutFile, HostileFilesAreErrors) {
    std::string deep = "panes: ";
    for (int i = 0; i < 5'000; ++i) deep += "{vertical: [";
    EXPECT_FALSE(errorOf(deep).empty());
    EXPECT_FALSE(errorOf(std::string(1U << 20U, 'x')).empty());
    EXPECT_FALSE(errorOf("").empty());
    EXPECT_FALSE(errorOf("panes: {pane: map}\narrangement: " + std::string(100'000, 'A')).empty());
}

TEST(LayoutFile, NoDamageOfAFileHarmsTheReader) {
    std::mt19937 random(7);
    const std::string good = Good;
    for (std::size_t length = 0; length < good.size(); ++length)
        (void)parseLayout(good.substr(0, length), "a.yaml");
    for (int round = 0; round < 2'000; ++round) {
        std::string damaged = good;
        for (int i = 0; i < 3; ++i) damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
        (void)parseLayout(damaged, "a.yaml");
    }
}

TEST(LayoutFile, ShippedOnesAreRight) {
    for (const char* name : {"drive", "explore", "map"}) {
        const auto layout = readLayout(sourceFolder() + "/resources/layouts/" + name + ".yaml");
        ASSERT_TRUE(layout) << layout.error().text;
        EXPECT_THAT(panesIn(layout->panes), testing::IsSupersetOf({"map", "strip", "alarms"})) << name;
    }
}

TEST(LayoutFile, OfTheShippedOnesDriveAloneFollowsTheRobot) {
    for (const char* name : {"drive", "explore", "map", "review", "link", "report", "compare"}) {
        const auto layout = readLayout(sourceFolder() + "/resources/layouts/" + name + ".yaml");
        ASSERT_TRUE(layout) << layout.error().text;
        const bool drive = layout->name == "drive";
        EXPECT_EQ(layout->map.follow, drive ? MapFollow::Above : MapFollow::Free) << name;
        EXPECT_EQ(layout->map.look, drive ? std::optional(MapLook::Top) : std::nullopt) << name;
    }
}

}  // namespace
}  // namespace leitstand::test
