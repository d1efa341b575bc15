#include <cstdlib>

#include <gtest/gtest.h>

#include "robots/simulation/arena/arena_generator.h"
#include "tests/simulation/drives/exploration.h"
#include "tests/simulation/victims/search_drive.h"

namespace leitstand::simulation::test {
namespace {

/// Kurt3D explores by itself and looks at what it finds.
SearchResult searchYellow(std::uint64_t seed, double seconds) {
    DriveSetup setup;
    setup.seed = seed;
    SearchDrive drive(generateArena(Grade::Yellow, seed), setup);
    if (std::getenv("LEITSTAND_CUES") != nullptr) {
        drive.search->onCue = [&](const PlacedCue& cue) {
            const Eigen::Vector3d place = drive.mapInArena() * cue.inMap;
            const auto& elements = drive.driven.world->arena().elements;
            const Element* nearest = nullptr;
            for (const Element& one : elements) {
                const bool counts = one.victim || one.kind == ElementKind::Lamp ||
                                    one.kind == ElementKind::Heater || one.kind == ElementKind::Sign ||
                                    one.kind == ElementKind::Spectator;
                if (counts && (nearest == nullptr || fromBody(one, place) < fromBody(*nearest, place)))
                    nearest = &one;
            }
            std::printf("CUE %.1f %s %s %.2f %.2f %.2f conf %.2f value %.1f '%s' dev %.2f near %s %.2f\n",
                        drive.driven.world->seconds(), cue.cue.kind.c_str(), cue.cue.sensor.c_str(),
                        place.x(), place.y(), place.z(), cue.cue.confidence, cue.cue.value,
                        cue.cue.text.c_str(), std::sqrt(cue.covariance.trace() / 3.0), nearest->name.c_str(),
                        fromBody(*nearest, place));
        };
    }
    SeenFloor floor(*drive.driven.world);
    const Exploration result = explore(drive.driven, floor, seconds);
    return judge(drive, "yellow " + std::to_string(seed) + ", " +
                            std::to_string(static_cast<int>(result.seconds)) + " s");
}

TEST(VictimSearchLong, ThreeYellowArenasAgainstTheTruth) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const SearchResult result = searchYellow(seed, 420.0);
        EXPECT_GE(result.lookedAt, 2) << seed;
        EXPECT_EQ(result.found, result.lookedAt) << seed;
        EXPECT_LE(result.worst, 0.2) << seed;
        EXPECT_LE(result.falseOnes, 1) << seed;
    }
}

TEST(VictimSearchTry, One) {
    const char* seed = std::getenv("LEITSTAND_SEED");
    const char* seconds = std::getenv("LEITSTAND_SECONDS");
    if (seed == nullptr || seconds == nullptr) GTEST_SKIP();
    (void)searchYellow(std::strtoull(seed, nullptr, 10), std::strtod(seconds, nullptr));
}

}  // namespace
}  // namespace leitstand::simulation::test
