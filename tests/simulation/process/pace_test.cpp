#include "robots/simulation/process/pace.h"

#include <map>
#include <string>

#include <gtest/gtest.h>

namespace leitstand::simulation::test {
namespace {

using namespace std::chrono_literals;

const Pace::Clock::time_point Begin{1h};

int steps(Pace& pace, Pace::Clock::time_point now) {
    int count = 0;
    while (pace.step(now)) ++count;
    return count;
}

TEST(Pace, KeepsTimeAndCatchesUpAfterAHiccup) {
    Pace pace;
    pace.begin(Begin);
    EXPECT_EQ(steps(pace, Begin + 4ms), 0);
    EXPECT_EQ(pace.next(), Begin + 5ms);
    EXPECT_EQ(steps(pace, Begin + 7ms), 1);
    EXPECT_EQ(steps(pace, Begin + 10ms), 1) << "the grid stays";
    EXPECT_EQ(steps(pace, Begin + 150ms), 28);
    EXPECT_EQ(pace.next(), Begin + 155ms);
}

TEST(Pace, LeavesOutWhatIsMoreThanAFifthOfASecond) {
    Pace pace;
    pace.begin(Begin);
    EXPECT_EQ(steps(pace, Begin + 10s), 40);
    EXPECT_EQ(pace.next(), Begin + 10s + 5ms);
}

TEST(Pace, DrawsFewPicturesWhileItIsBehind) {
    Pace pace;
    pace.begin(Begin);
    for (int i = 0; i < 10; ++i) EXPECT_TRUE(pace.mayDraw("left", Begin + 100ms)) << "in time";
    int drawn = 0;
    for (int i = 0; i < 50; ++i) drawn += pace.mayDraw("left", Begin + 110ms) ? 1 : 0;
    EXPECT_EQ(drawn, 10) << "one of five: never none";
    EXPECT_TRUE(pace.mayDraw("left", Begin));
}

// Two cameras at twice the rate of the right one: with one share for all of them, the right one's turn never
// came.
TEST(Pace, EveryCameraHasItsShareOfTheFew) {
    Pace pace;
    pace.begin(Begin);
    std::map<std::string, int> drawn;
    for (int i = 0; i < 50; ++i) {
        for (const char* camera : {"left", "right", "infrared", "left", "infrared"})
            drawn[camera] += pace.mayDraw(camera, Begin + 110ms) ? 1 : 0;
    }
    EXPECT_EQ(drawn, (std::map<std::string, int>{{"infrared", 20}, {"left", 20}, {"right", 10}}));
}

}  // namespace
}  // namespace leitstand::simulation::test
