#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "core/perception/cues/motion.h"
#include "tests/films/film.h"

namespace leitstand::test {
namespace {

struct Pixel {
    int x, y;
};
bool isIn(const MotionBlob& blob, const Pixel& pixel) {
    return pixel.x >= blob.left && pixel.x <= blob.right && pixel.y >= blob.top && pixel.y <= blob.bottom;
}

/// Where people walk in some pictures of the film, marked by hand.
const std::map<int, std::vector<Pixel>> Walkers = {
    {50, {{387, 220}, {420, 222}, {446, 210}, {525, 262}, {567, 257}, {693, 315}}},
    {650, {{152, 183}, {231, 190}, {333, 195}, {484, 270}, {655, 235}, {357, 445}}}};
/// Parked cars, a road sign, a rock, a board, what lies on the grass. (A barrier tape is in the wind.)
constexpr std::array Still = {Pixel{686, 72}, Pixel{752, 72}, Pixel{598, 55},  Pixel{177, 262},
                              Pixel{39, 124}, Pixel{32, 321}, Pixel{115, 512}, Pixel{203, 68}};

/// A film of OpenCV (vtest.avi: view 1 of PETS 2009, S2.L1), out of Debian's opencv-doc; LEITSTAND_FILM names
/// the folder into which packaging/others-pictures.sh got it.
TEST(LongFilm, PeopleWhoWalkBeforeACameraAtRestMoveAndNothingElseDoes) {
    const char* named = std::getenv("LEITSTAND_FILM");
    const std::filesystem::path film = std::filesystem::path(named != nullptr ? named : "") / "vtest.avi";
    if (!std::filesystem::exists(film))
        GTEST_SKIP() << "SKIPPED: no film of others here: packaging/others-pictures.sh gets it";
    MotionFinder finder;
    int number = 0, people = 0, found = 0;
    readFilm(film, [&](const Picture& picture, Time at) {
        const std::vector<MotionBlob> blobs = finder.look(picture, at);
        const auto moves = [&](const Pixel& pixel) {
            return std::any_of(blobs.begin(), blobs.end(),
                               [&](const MotionBlob& blob) { return isIn(blob, pixel); });
        };
        if (const auto here = Walkers.find(number); here != Walkers.end()) {
            for (const Pixel& walker : here->second) {
                ++people;
                if (moves(walker))
                    ++found;
                else
                    std::printf("picture %d: who walks at %d, %d is not found\n", number, walker.x, walker.y);
            }
            for (const Pixel& thing : Still)
                EXPECT_FALSE(moves(thing)) << "picture " << number << " at " << thing.x << ", " << thing.y;
        }
        return ++number <= Walkers.rbegin()->first;
    });
    std::printf("%d pictures of 768 x 576, %d of %d people move\n", number, found, people);
    EXPECT_EQ(number, Walkers.rbegin()->first + 1);
    EXPECT_EQ(found, people);
    EXPECT_EQ(people, 12);
}

}  // namespace
}  // namespace leitstand::test
