#include <cmath>

#include <gtest/gtest.h>

#include "robots/simulation/arena/arena_file.h"
#include "robots/simulation/arena/arena_generator.h"
#include "robots/simulation/arena/reachable_floor.h"
#include "tests/simulation/arena/mesh_checks.h"

namespace leitstand::simulation {
namespace {

constexpr std::uint64_t Seeds = 50;
constexpr double RobotRadius = 0.25;  ///< [m]

int countOf(const Arena& arena, ElementKind kind) {
    int count = 0;
    for (const Element& element : arena.elements) count += element.kind == kind ? 1 : 0;
    return count;
}

template <class Check>
void forSeeds(Grade grade, const Check& check) {
    for (std::uint64_t seed = 0; seed < Seeds; ++seed) {
        SCOPED_TRACE(toString(grade) + " " + std::to_string(seed));
        check(generateArena(grade, seed));
    }
}

/// What all arenas have.
void checkArena(const Arena& arena) {
    ASSERT_TRUE(arena.starts.contains("kurt3d"));
    ASSERT_TRUE(arena.starts.contains("crawler"));
    const ReachableFloor floor = reachableFloor(arena, RobotRadius);
    for (const auto& [robot, start] : arena.starts)
        EXPECT_TRUE(floor.at(start.translation().head<2>())) << robot;
    const double apart = distanceBetween(arena.starts.at("kurt3d"), arena.starts.at("crawler"));
    EXPECT_GT(apart, 0.5);
    EXPECT_LT(apart, 1.0);
    for (const Element& element : arena.elements) {
        if (element.kind != ElementKind::Victim) continue;
        ASSERT_TRUE(element.victim);
        EXPECT_GE(element.victim->temperature, 20.0);
        EXPECT_LE(element.victim->temperature, 37.0);
        EXPECT_FALSE(element.victim->tag.empty());
    }
    EXPECT_GE(countOf(arena, ElementKind::Sign), 5);
    EXPECT_GE(countOf(arena, ElementKind::Spectator), 2);
    EXPECT_GE(countOf(arena, ElementKind::Lamp), 5);
}

TEST(ArenaGenerator, SameSeedSameArenaAnotherSeedAnother) {
    for (const Grade grade : {Grade::Yellow, Grade::Orange, Grade::Red}) {
        for (std::uint64_t seed = 0; seed < 5; ++seed) {
            const std::string first = writeArena(generateArena(grade, seed));
            EXPECT_EQ(first, writeArena(generateArena(grade, seed)));
            EXPECT_NE(first, writeArena(generateArena(grade, seed + 1)));
        }
    }
}

TEST(ArenaGenerator, AnotherSeedMovesWallsAndVictims) {
    const Arena one = generateArena(Grade::Yellow, 1);
    const Arena other = generateArena(Grade::Yellow, 2);
    const auto places = [](const Arena& arena, ElementKind kind) {
        std::vector<Eigen::Vector3d> all;
        for (const Element& element : arena.elements) {
            if (element.kind == kind) all.push_back(element.pose.translation());
        }
        return all;
    };
    EXPECT_NE(places(one, ElementKind::Wall), places(other, ElementKind::Wall));
    EXPECT_NE(places(one, ElementKind::Victim), places(other, ElementKind::Victim));
}

TEST(ArenaGenerator, YellowIsAMazeWhereAllUnhiddenWarmVictimsCanBeReached) {
    int curtains = 0;
    int ramps = 0;
    double least = 1e9;
    forSeeds(Grade::Yellow, [&](const Arena& arena) {
        checkArena(arena);
        const ReachableFloor floor = reachableFloor(arena, RobotRadius);
        const int victims = countOf(arena, ElementKind::Victim);
        EXPECT_GE(victims, 3);
        EXPECT_LE(victims, 6);
        int findable = 0;
        for (const Element& element : arena.elements) {
            if (element.kind == ElementKind::Victim && !element.victim->hidden &&
                element.victim->temperature >= 30) {
                ++findable;
                EXPECT_TRUE(reaches(floor, element)) << element.name;
            }
            if (element.kind == ElementKind::Ramp) {
                EXPECT_LE(inDegrees(std::atan2(element.size.z(), element.size.x())), 15.1);
            }
            EXPECT_NE(element.kind, ElementKind::Stairs);
        }
        EXPECT_GE(findable, 2);
        curtains += countOf(arena, ElementKind::Curtain);
        ramps += countOf(arena, ElementKind::Ramp);
        EXPECT_GE(countOf(arena, ElementKind::Ceiling), 1);
        least = std::min(least, floor.area());
    });
    EXPECT_GT(curtains, 30);
    EXPECT_GT(ramps, 60);
    EXPECT_GT(least, 12.0);
    std::printf("least floor that the middle of a robot reaches: %.1f m2\n", least);
}

TEST(ArenaGenerator, OrangeHasTwoLevelsJoinedByStairsAndARamp) {
    forSeeds(Grade::Orange, [&](const Arena& arena) {
        checkArena(arena);
        ASSERT_EQ(countOf(arena, ElementKind::Stairs), 1);
        double upper = 0.0;
        bool high = false;
        for (const Element& element : arena.elements) {
            if (element.kind == ElementKind::Stairs) {
                EXPECT_GE(element.riser, 0.08 - 1e-9);
                EXPECT_LE(element.riser, 0.10 + 1e-9);
                EXPECT_NEAR(std::fmod(element.size.z() / element.riser + 1e-6, 1.0), 0.0, 1e-5);
                upper = element.size.z();
            }
        }
        for (const Element& element : arena.elements) {
            high = high || (element.kind == ElementKind::Victim && element.pose.translation().z() == upper);
        }
        // Kurt3D gets up by the ramp.
        const ReachableFloor floor = reachableFloor(arena, RobotRadius);
        const double level = arena.to.y() - 2 * 1.3;
        double above = 0.0;
        for (int i = 0; i < floor.rows * floor.columns; ++i) {
            const double y = floor.from.y() + floor.cell * (i / floor.columns + 0.5);
            if (y > level + 0.1 && floor.reached[static_cast<std::size_t>(i)] != 0)
                above += floor.cell * floor.cell;
        }
        EXPECT_GT(above, 1.0);
    });
}

TEST(ArenaGenerator, RedHasStepFieldsAndRubble) {
    forSeeds(Grade::Red, [&](const Arena& arena) {
        checkArena(arena);
        EXPECT_GE(countOf(arena, ElementKind::StepField), 5);
        EXPECT_GE(countOf(arena, ElementKind::Rubble), 1);
        for (const Element& element : arena.elements) {
            EXPECT_EQ(element.heights.size(), element.kind == ElementKind::StepField ? 144U : 0U);
        }
    });
}

TEST(ArenaGenerator, MeshesOfAllGradesAreConsistentAndSmallEnoughForRays) {
    for (const Grade grade : {Grade::Yellow, Grade::Orange, Grade::Red}) {
        for (std::uint64_t seed = 0; seed < 10; ++seed) {
            const ArenaMesh mesh = meshOf(generateArena(grade, seed));
            EXPECT_EQ(test::faultOf(mesh.still), "");
            EXPECT_LT(mesh.still.triangles.size(), 60'000U);
            const double all = test::areaOf(mesh.still);
            EXPECT_GT(test::areaOf(mesh.still, Label::Wall), 0.15 * all);
            EXPECT_GT(test::areaOf(mesh.still, Label::Floor), 0.2 * all);
        }
    }
}

TEST(ReachableFloor, EndsAtWallsAndBeforeSteps) {
    Arena arena;
    arena.to = {4.0, 2.0};
    arena.starts["kurt3d"] = poseFrom({0.5, 1.0, 0.0}, 0, 0, 0);
    Element wall = elementOf(ElementKind::Wall);
    wall.size = {2.0, 0.05, 1.0};
    wall.pose = poseFrom({2.0, 1.0, 0.0}, 0, 0, degrees(90));
    arena.elements = {wall};
    EXPECT_NEAR(reachableFloor(arena, 0.25).area(), (2.0 - 0.3) * 2.0, 0.25);
    EXPECT_FALSE(reachableFloor(arena, 0.25).at({3.0, 1.0}));

    arena.elements[0] = elementOf(ElementKind::Curtain);  // gives way
    arena.elements[0].pose = wall.pose;
    EXPECT_TRUE(reachableFloor(arena, 0.25).at({3.0, 1.0}));

    Element step = elementOf(ElementKind::Floor);
    step.size = {2.0, 2.0, 0.1};
    step.pose = poseFrom({3.0, 1.0, 0.1}, 0, 0, 0);
    arena.elements = {step};
    EXPECT_FALSE(reachableFloor(arena, 0.25).at({3.0, 1.0}));
    EXPECT_TRUE(reachableFloor(arena, 0.25, 0.12).at({3.0, 1.0}));
}

TEST(Generator, NoSignHidesAnother) {
    for (const Grade grade : {Grade::Yellow, Grade::Orange, Grade::Red}) {
        for (std::uint64_t seed = 1; seed <= 30; ++seed) {
            const Arena arena = generateArena(grade, seed);
            std::vector<Element> signs;
            for (const Element& element : arena.elements) {
                if (element.kind == ElementKind::Sign) signs.push_back(element);
            }
            for (std::size_t i = 0; i < signs.size(); ++i) {
                for (std::size_t j = 0; j < i; ++j) {
                    const Eigen::Vector3d apart = signs[i].pose.inverse() * signs[j].pose.translation();
                    const bool sameWall = signs[i].pose.linear().isApprox(signs[j].pose.linear(), 1e-6) &&
                                          std::abs(apart.y()) < 0.02;
                    EXPECT_FALSE(sameWall && std::abs(apart.x()) < 0.25 && std::abs(apart.z()) < 0.25)
                        << arena.name << ": " << signs[i].name << ", " << signs[j].name;
                }
            }
        }
    }
}

}  // namespace
}  // namespace leitstand::simulation
