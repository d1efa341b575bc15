#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robots/simulation/arena/arena_file.h"
#include "robots/simulation/arena/arena_generator.h"
#include "robots/simulation/arena/mesh.h"
#include "robots/simulation/arena/random.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::simulation {
namespace {

using testing::HasSubstr;

const std::string Head = "name: test\ngrade: yellow\nfrom: [0, 0]\nto: [4, 4]\n";

void expectEqual(const Element& a, const Element& b) {
    SCOPED_TRACE(a.name);
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.pose.matrix(), b.pose.matrix());
    EXPECT_EQ(a.size, b.size);
    EXPECT_EQ(a.material, b.material);
    EXPECT_EQ(a.temperature, b.temperature);
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.angle, b.angle);
    EXPECT_EQ(a.riser, b.riser);
    EXPECT_EQ(a.cell, b.cell);
    EXPECT_EQ(a.heights, b.heights);
    EXPECT_EQ(a.text, b.text);
    EXPECT_EQ(a.seed, b.seed);
    ASSERT_EQ(a.victim.has_value(), b.victim.has_value());
    if (!a.victim) return;
    EXPECT_EQ(a.victim->tag, b.victim->tag);
    EXPECT_EQ(a.victim->situation, b.victim->situation);
    EXPECT_EQ(a.victim->waving, b.victim->waving);
    EXPECT_EQ(a.victim->temperature, b.victim->temperature);
    EXPECT_EQ(a.victim->co2, b.victim->co2);
    EXPECT_EQ(a.victim->hidden, b.victim->hidden);
}

void expectEqual(const Arena& a, const Arena& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.grade, b.grade);
    EXPECT_EQ(a.seed, b.seed);
    EXPECT_EQ(a.from, b.from);
    EXPECT_EQ(a.to, b.to);
    EXPECT_EQ(a.ambient, b.ambient);
    EXPECT_EQ(a.light, b.light);
    ASSERT_EQ(a.starts.size(), b.starts.size());
    for (const auto& [robot, start] : a.starts) EXPECT_EQ(start.matrix(), b.starts.at(robot).matrix());
    ASSERT_EQ(a.elements.size(), b.elements.size());
    for (std::size_t i = 0; i < a.elements.size(); ++i) expectEqual(a.elements[i], b.elements[i]);
}

TEST(ArenaFile, GeneratedArenasOfAllGradesComeBackEqual) {
    for (const Grade grade : {Grade::Yellow, Grade::Orange, Grade::Red}) {
        for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{7}, UINT64_MAX}) {
            SCOPED_TRACE(toString(grade));
            const Arena arena = generateArena(grade, seed);
            const auto again = parseArena(writeArena(arena), "again");
            ASSERT_TRUE(again) << again.error().text;
            expectEqual(arena, *again);
        }
    }
}

TEST(ArenaFile, WhatLooksStraightUpOrDownComesBack) {
    for (const double pitch : {90.0, -90.0, 89.9999999, 270.0}) {
        Arena arena;
        arena.name = "steep";
        arena.to = {3, 3};
        Element door = elementOf(ElementKind::Wall);
        door.name = "door";
        door.pose = poseFrom({1, 2, 3}, degrees(30), degrees(pitch), degrees(1));
        arena.elements.push_back(door);
        const auto again = parseArena(writeArena(arena), "again");
        ASSERT_TRUE(again) << again.error().text;
        EXPECT_LT((again->elements[0].pose.matrix() - door.pose.matrix()).cwiseAbs().maxCoeff(), 1e-14)
            << pitch;
    }
}

TEST(ArenaFile, OddNamesAndPosesComeBack) {
    Arena arena;
    arena.name = "\"quotes\" \\ and: #signs";
    arena.to = {3.0, 0.1 + 0.2};
    arena.ambient = -3.5;
    arena.starts["robot_1"] = poseFrom({1.0 / 3.0, 0.0, 0.0}, 0.0, 0.0, degrees(-90));
    Element wall = elementOf(ElementKind::Wall);
    wall.name = "- x";
    wall.pose = poseFrom({1e-7, 2.0, 3.0}, 0.3, -0.2, 1.234567891);
    wall.seed = UINT64_MAX;
    arena.elements.push_back(wall);
    const auto again = parseArena(writeArena(arena), "again");
    ASSERT_TRUE(again) << again.error().text;
    EXPECT_EQ(again->name, arena.name);
    EXPECT_EQ(again->to, arena.to);
    EXPECT_EQ(again->starts.at("robot_1").matrix(), arena.starts.at("robot_1").matrix());
    EXPECT_EQ(again->elements[0].name, wall.name);
    EXPECT_EQ(again->elements[0].seed, UINT64_MAX);
    EXPECT_TRUE(again->elements[0].pose.isApprox(wall.pose, 1e-14));
}

TEST(ArenaFile, WhatIsMissingIsUsual) {
    const auto arena = parseArena(Head +
                                      "ambient: 15\nelements:\n"
                                      "  - {kind: stairs, position: [1, 2, 0]}\n"
                                      "  - {kind: heater, position: [1, 2, 0]}\n",
                                  "a.yaml");
    ASSERT_TRUE(arena) << arena.error().text;
    EXPECT_EQ(arena->elements[0].riser, 0.1);
    EXPECT_EQ(arena->elements[0].temperature, 15.0);
    EXPECT_EQ(arena->elements[1].temperature, 45.0);
    EXPECT_NE(arena->elements[0].name, arena->elements[1].name);
}

TEST(ArenaFile, TheManualsExampleIsRead) {
    const std::string manual = test::readText(test::sourceFolder() + "/docs/simulation.md");
    const std::string mark = "```yaml\nname: corridor";
    const auto begin = manual.find(mark);
    ASSERT_NE(begin, std::string::npos);
    const auto from = begin + std::string("```yaml\n").size();
    const auto arena = parseArena(manual.substr(from, manual.find("```", from) - from), "docs/simulation.md");
    ASSERT_TRUE(arena) << arena.error().text;
    EXPECT_EQ(arena->elements.size(), 4U);
}

TEST(ArenaFile, ErrorsNameFileLineKeyAndExpectation) {
    struct Case {
        std::string text;
        std::vector<std::string> parts;
    };
    const std::string one = Head + "elements:\n  - ";
    const std::vector<Case> cases = {
        {"", {"a.yaml", "found nothing"}},
        {"[1, 2]", {"a.yaml:1", "expected keys and values"}},
        {"grade: [", {"a.yaml:"}},
        {"from: [0, 0]\nto: [4, 4]\ngrad: red\n",
         {"a.yaml:3", "expected one of the keys", "\"grad\"", "did you mean grade?"}},
        {"from: [0, 0]\nto: [4, 4]\ngrade: green\n",
         {"a.yaml:3: grade", "yellow, orange, red or building", "\"green\""}},
        {"from: [0, 0]\n", {"to: expected 2 numbers"}},
        {"from: [0, 0]\nto: [4, 0]\n", {"a.yaml:2: to", "beyond \"from\""}},
        {"from: [0, 0]\nto: [4, 400]\n", {"a.yaml:2: to", "at most 100 m"}},
        {"from: [0, .nan]\nto: [4, 4]\n", {"a.yaml:1: from", "2 numbers"}},
        {Head + "light: 3\n", {"a.yaml:5: light", "from 0 to 1"}},
        {Head + "seed: -1\n", {"a.yaml:5: seed", "whole number"}},
        {Head + "seed: 1.5\n", {"a.yaml:5: seed", "whole number"}},
        {Head + "elements: wall\n", {"a.yaml:5: elements", "expected a list"}},
        {Head + "starts:\n  kurt3d: {turn: [0, 0, 90]}\n", {"a.yaml:6: starts.kurt3d.position", "3 numbers"}},
        {one + "5\n", {"a.yaml:6: elements[0]", "expected keys and values"}},
        {one + "{position: [0, 0, 0]}\n", {"a.yaml:6: elements[0].kind", "expected the kind"}},
        {one + "{kind: wal, position: [0, 0, 0]}\n", {"elements[0].kind", "floor, wall, door", "\"wal\""}},
        {one + "{kind: wall}\n", {"elements[0].position", "3 numbers"}},
        {one + "{kind: wall, position: [0, 0]}\n", {"elements[0].position", "3 numbers"}},
        {one + "{kind: wall, position: [0, 0, 0], size: [1, 0, 1]}\n", {"elements[0].size", "0.001"}},
        {one + "{kind: wall, position: [0, 0, 0], material: gold}\n",
         {"elements[0].material", "plywood", "\"gold\""}},
        {one + "{kind: wall, position: [0, 0, 0], temperature: 5000}\n", {"elements[0].temperature", "500"}},
        {one + "{kind: wall, position: [0, 0, 0], riser: 0.1}\n",
         {"elements[0].riser", "no such key for a wall"}},
        {one + "{kind: stairs, position: [0, 0, 0], size: [9, 1, 90], riser: 0.01}\n",
         {"riser", "200 steps"}},
        {one + "{kind: step_field, position: [0, 0, 0], size: [0.2, 0.1, 1], heights: [1]}\n",
         {"elements[0].heights", "2 x 1 numbers", "found 1"}},
        {one + "{kind: step_field, position: [0, 0, 0], size: [0.2, 0.1, 1], heights: [1, x]}\n",
         {"some of them wrong"}},
        {one + "{kind: step_field, position: [0, 0, 0], size: [99, 99, 1], cell: 0.01}\n",
         {"elements[0].cell", "100 cells"}},
        {one + "{kind: sign, position: [0, 0, 0], text: hello}\n", {"elements[0].text", "qr:TEXT"}},
        {one + "{kind: sign, position: [0, 0, 0], text: \"hazard:bees\"}\n",
         {"elements[0].text", "flammable"}},
        {one + "{kind: sign, position: [0, 0, 0], text: \"qr:" + std::string(63, 'x') + "\"}\n",
         {"62 bytes", "found 63"}},
        {one + "{kind: victim, position: [0, 0, 0], victim: {situation: lost}}\n",
         {"elements[0].victim.situation", "surface, trapped, void or entombed"}},
        {one + "{kind: victim, position: [0, 0, 0], victim: {co2: -4}}\n", {"elements[0].victim.co2"}},
        {one + "{kind: wall, name: a, position: [0, 0, 0]}\n  - {kind: wall, name: a, position: [0, 0, 0]}\n",
         {"elements[1].name", "\"a\" again"}},
        {one + "&a {kind: wall, position: [0, 0, 0]}\n", {"a.yaml:6", "no anchor"}},
    };
    for (const Case& one : cases) {
        SCOPED_TRACE(one.text);
        const auto arena = parseArena(one.text, "a.yaml");
        ASSERT_FALSE(arena);
        for (const std::string& part : one.parts) EXPECT_THAT(arena.error().text, HasSubstr(part));
    }
}

TEST(ArenaFile, TellsAllThatIsWrongAtOnce) {
    const auto arena =
        parseArena(Head + "light: 2\nambient: 900\nelements: [{kind: x, position: [0, 0, 0]}]\n", "a.yaml");
    ASSERT_FALSE(arena);
    for (const char* key : {"light", "ambient", "elements[0].kind"})
        EXPECT_THAT(arena.error().text, HasSubstr(key));
}

TEST(ArenaFile, IsReadFromDisk) {
    const test::TemporaryFolder folder;
    const auto file = folder.path() / "a.yaml";
    std::ofstream(file) << writeArena(generateArena(Grade::Red, 3));
    const auto arena = readArena(file);
    ASSERT_TRUE(arena) << arena.error().text;
    EXPECT_EQ(arena->name, "red 3");
    const auto missing = readArena(folder.path() / "none.yaml");
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().text, HasSubstr("none.yaml: cannot be opened"));
    EXPECT_FALSE(readArena(folder.path()));
}

TEST(ArenaFile, MutatedFilesAreReadOrRefusedAndNeverCrash) {
    std::string whole = writeArena(generateArena(Grade::Orange, 2));
    whole.resize(6'000);
    whole.resize(whole.rfind("  - {"));
    Random random(4);
    int read = 0;
    for (int i = 0; i < 300; ++i) {
        std::string text = whole;
        for (int changes = 1 + random.below(4); changes > 0; --changes) {
            const auto place = static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
            const std::string_view usual = "0123456789-.,:[]{}\"\n e";
            switch (random.below(4)) {
                case 0:
                    text[place] = static_cast<char>(random.below(256));
                    break;
                case 1:
                    text[place] =
                        usual[static_cast<std::size_t>(random.below(static_cast<int>(usual.size())))];
                    break;
                case 2:
                    text.erase(place, static_cast<std::size_t>(1 + random.below(20)));
                    break;
                default:
                    text.insert(place, text.substr(place / 2, 15));
                    break;
            }
        }
        const auto arena = parseArena(text, "a.yaml");
        if (!arena) {
            EXPECT_THAT(arena.error().text, HasSubstr("a.yaml"));
            continue;
        }
        ++read;
        EXPECT_TRUE(parseArena(writeArena(*arena), "again"));
        EXPECT_LT(meshOf(*arena).still.triangles.size(), 200'000U);
    }
    EXPECT_GT(read, 3);
}

}  // namespace
}  // namespace leitstand::simulation
