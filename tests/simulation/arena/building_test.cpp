#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "robots/simulation/arena/arena_file.h"
#include "robots/simulation/arena/arena_generator.h"
#include "robots/simulation/arena/building_generator.h"
#include "robots/simulation/arena/reachable_floor.h"
#include "tests/simulation/arena/mesh_checks.h"

namespace leitstand::simulation {
namespace {

constexpr double KurtRadius = 0.25;  ///< [m]

Building made(const BuildingSettings& settings, std::uint64_t seed) {
    auto building = generateBuilding(settings, seed);
    EXPECT_TRUE(building) << building.error().text;
    return std::move(building).value();
}

std::vector<const Element*> all(const Arena& arena, ElementKind kind) {
    std::vector<const Element*> found;
    for (const Element& element : arena.elements) {
        if (element.kind == kind) found.push_back(&element);
    }
    return found;
}

/// The usual one, small and large ones with storeys, twins and bare corridors.
std::vector<BuildingSettings> variants() {
    std::vector<BuildingSettings> settings(7);
    settings[1].storeys = 2;
    settings[2].width = 28.0;
    settings[2].depth = 20.0;
    settings[2].storeys = 3;
    settings[3].twins = true;
    settings[3].storeys = 2;
    settings[4].smooth = true;
    settings[4].storeys = 2;
    settings[5].width = settings[5].depth = 90.0;
    settings[5].storeys = 3;
    settings[6].troubles = false;
    return settings;
}

const ReachableFloor& floorAt(const std::vector<ReachableFloor>& floors, double height) {
    return *std::min_element(floors.begin(), floors.end(), [&](const auto& a, const auto& b) {
        return std::abs(a.level - height) < std::abs(b.level - height);
    });
}

TEST(Building, TheSameSeedIsTheSameBuildingAnotherSeedAnother) {
    for (const BuildingSettings& settings : variants()) {
        const std::string first = writeArena(made(settings, 1).arena);
        EXPECT_EQ(first, writeArena(made(settings, 1).arena));
        EXPECT_NE(first, writeArena(made(settings, 2).arena));
    }
    EXPECT_EQ(writeArena(made({}, 7).arena), writeArena(generateArena(Grade::Building, 7)));
}

TEST(Building, ComesBackFromItsFile) {
    for (const BuildingSettings& settings : variants()) {
        const Arena arena = made(settings, 3).arena;
        const std::string text = writeArena(arena);
        const auto again = parseArena(text, "again");
        ASSERT_TRUE(again) << arena.name << ": " << again.error().text;
        EXPECT_EQ(writeArena(*again), text) << arena.name;
    }
}

TEST(Building, KurtGetsToAllRoomsOfAllStoreys) {
    for (const BuildingSettings& settings : variants()) {
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            const Building building = made(settings, seed);
            SCOPED_TRACE(building.arena.name);
            const auto floors = reachableStoreys(building.arena, KurtRadius);
            ASSERT_EQ(floors.size(), static_cast<std::size_t>(settings.storeys));
            EXPECT_EQ(building.ways.rooms.empty(), settings.smooth);
            for (const Eigen::Vector3d& room : building.ways.rooms)
                EXPECT_TRUE(floorAt(floors, room.z()).at(room.head<2>())) << room.transpose();
            ASSERT_EQ(building.ways.ramps.size() + 1, floors.size());
            for (const auto& ramp : building.ways.ramps) {
                for (const Eigen::Vector3d& corner : {ramp.front(), ramp.back()})
                    EXPECT_TRUE(floorAt(floors, corner.z()).at(corner.head<2>())) << corner.transpose();
            }
            for (const Element* victim : all(building.arena, ElementKind::Victim)) {
                EXPECT_TRUE(reaches(floorAt(floors, victim->pose.translation().z()), *victim))
                    << victim->name << " at " << victim->pose.translation().transpose();
            }
            for (const auto& [robot, start] : building.arena.starts)
                EXPECT_TRUE(floors.front().at(start.translation().head<2>())) << robot;
        }
    }
}

TEST(Building, UpperStoreysAreReachedByTheRampAlone) {
    BuildingSettings settings;
    settings.storeys = 2;
    Arena arena = made(settings, 1).arena;
    EXPECT_GT(reachableStoreys(arena, KurtRadius)[1].area(), 500.0);
    std::erase_if(arena.elements, [](const Element& one) { return one.kind == ElementKind::Ramp; });
    const auto floors = reachableStoreys(arena, KurtRadius);
    EXPECT_GT(floors[0].area(), 500.0);
    // What is seen through the hole still counts for both.
    EXPECT_LT(floors[1].area(), 40.0);
}

TEST(Building, CorridorsAreWideAndRampsAreNotSteep) {
    for (const BuildingSettings& settings : variants()) {
        const Building building = made(settings, 4);
        SCOPED_TRACE(building.arena.name);
        // A robot three times as wide still gets around the ring and through the cross corridor.
        const auto floors = reachableStoreys(building.arena, 0.7);
        const Eigen::Vector2d low = building.ways.ring.min(), high = building.ways.ring.max();
        for (const Eigen::Vector2d& place :
             {low, high, Eigen::Vector2d(low.x(), high.y()), Eigen::Vector2d(high.x(), low.y()),
              Eigen::Vector2d(building.ways.cross, building.ways.ring.center().y())})
            EXPECT_LT(floors[0].distanceTo(place), 0.8) << place.transpose();
        for (const Element* ramp : all(building.arena, ElementKind::Ramp))
            EXPECT_LE(inDegrees(std::atan2(ramp->size.z(), ramp->size.x())), 12.0);
        EXPECT_EQ(all(building.arena, ElementKind::Stairs).size(),
                  static_cast<std::size_t>(settings.storeys) - 1);
    }
}

TEST(Building, HasWhatMakesMappingHard) {
    const Arena arena = made({}, 1).arena;
    const auto of = [&](Material material) {
        return std::count_if(arena.elements.begin(), arena.elements.end(), [&](const Element& one) {
            return one.kind == ElementKind::Wall && one.material == material;
        });
    };
    EXPECT_GE(of(Material::Pane), 2);
    EXPECT_GE(of(Material::Black), 2);
    EXPECT_EQ(all(arena, ElementKind::Smoke).size(), 2U);
    EXPECT_GE(all(arena, ElementKind::Spectator).size(), 2U);
    EXPECT_GE(all(arena, ElementKind::Door).size(), 20U);
    EXPECT_GE(all(arena, ElementKind::Victim).size(), 3U);
    EXPECT_GE(all(arena, ElementKind::Sign).size(), 4U);
    BuildingSettings smooth;
    smooth.smooth = true;
    const Arena bare = made(smooth, 1).arena;
    for (const ElementKind kind : {ElementKind::Door, ElementKind::Table, ElementKind::Smoke})
        EXPECT_TRUE(all(bare, kind).empty()) << toString(kind);
}

TEST(Building, RoomsOfTwinsAreAlikeWhereverTheyAre) {
    BuildingSettings settings;
    settings.twins = true;
    const Arena arena = made(settings, 1).arena;
    const auto doors = all(arena, ElementKind::Door);
    ASSERT_GE(doors.size(), 20U);
    for (const Element* door : doors) {
        EXPECT_EQ(door->width, doors.front()->width);
        EXPECT_EQ(door->angle, doors.front()->angle);
    }
}

TEST(Building, MeshesAreConsistent) {
    for (const BuildingSettings& settings : variants()) {
        const ArenaMesh mesh = meshOf(made(settings, 2).arena);
        EXPECT_EQ(test::faultOf(mesh.still), "");
        EXPECT_LT(mesh.still.triangles.size(), 400'000U);
    }
}

TEST(Building, RefusesWhatItCannotBuild) {
    const auto refused = [](double width, double depth, int storeys) {
        BuildingSettings settings;
        settings.width = width;
        settings.depth = depth;
        settings.storeys = storeys;
        const auto building = generateBuilding(settings, 1);
        return building ? std::string() : building.error().text;
    };
    EXPECT_EQ(refused(1, 1, 1), "size 1x1: expected a building of 28x20 to 90x90 m");
    EXPECT_NE(refused(1e9, 40, 1), "");
    EXPECT_NE(refused(60, std::nan(""), 1), "");
    EXPECT_NE(refused(-60, 40, 1), "");
    EXPECT_EQ(refused(60, 40, 0), "storeys 0: expected 1 to 3");
    EXPECT_EQ(refused(60, 40, 50), "storeys 50: expected 1 to 3");
    EXPECT_EQ(refused(28, 20, 3), "");
    for (const char* text : {"", "60", "60x", "x40", "1e9", "1e9x1e9", "-60x40", "60x40x2", "nanxnan"})
        EXPECT_FALSE(buildingSizeFrom(text)) << text;
    EXPECT_EQ(*buildingSizeFrom("30x20.5"), Eigen::Vector2d(30.0, 20.5));
}

}  // namespace
}  // namespace leitstand::simulation
