#include "core/perception/cues/motion.h"

#include <chrono>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "tests/core/perception/cues/cue_pictures.h"

namespace leitstand::test {
namespace {

using std::chrono::milliseconds;

/// A wall with a pattern, and an arm that waves before it.
class Scene {
public:
    Scene() : m_wall(240, 320, CV_8UC1, cv::Scalar(110)) {
        for (int x = 0; x < 320; x += 40) cv::line(m_wall, {x, 0}, {x, 239}, 140, 3);
    }
    [[nodiscard]] Picture at(double seconds, bool waves, double gain = 1.0) {
        cv::Mat picture = m_wall.clone();
        const double angle = waves ? 0.5 * std::sin(seconds / 1.4 * 6.283) : 0.0;
        const cv::Point2d shoulder(200, 150);
        const cv::Point2d hand(shoulder.x + 45 * std::sin(angle), shoulder.y - 45 * std::cos(angle));
        cv::line(picture, shoulder, hand, 215, 12);
        picture.convertTo(picture, CV_8U, gain);
        return pictureFrom(noisy(picture, 3.0, m_seed++));
    }

private:
    cv::Mat m_wall;
    unsigned m_seed = 1;
};

Time at(double seconds) {
    return Time(milliseconds(1'000'000 + static_cast<int>(seconds * 1000.0)));
}

TEST(Motion, AWavingArmIsFoundWhereItIs) {
    Scene scene;
    MotionFinder finder;
    std::vector<MotionBlob> found;
    for (double time = 0.0; time < 4.0; time += 0.2) found = finder.look(scene.at(time, true), at(time));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].centre.x(), 200.0, 12.0);
    EXPECT_NEAR(found[0].centre.y(), 120.0, 20.0);
    EXPECT_GT(found[0].strength, 0.3);
    EXPECT_LT(found[0].right - found[0].left, 100);
}

TEST(Motion, NoiseAndGainAreNone) {
    Scene scene;
    MotionFinder finder;
    for (double time = 0.0; time < 6.0; time += 0.2) {
        const double gain = 1.0 + 0.15 * std::sin(time);
        EXPECT_TRUE(finder.look(scene.at(time, false, gain), at(time)).empty()) << time;
    }
}

TEST(Motion, NothingIsToldWhileTheCameraMovesOrThePictureRepeats) {
    Scene scene;
    MotionFinder finder;
    for (double time = 0.0; time < 4.0; time += 0.2) {
        finder.moved();
        EXPECT_TRUE(finder.look(scene.at(time, true), at(time)).empty());
    }
    const Picture still = scene.at(4.0, true);
    for (double time = 4.0; time < 8.0; time += 0.2) {
        EXPECT_TRUE(finder.look(still, at(time)).empty()) << "a driver that hangs";
    }
}

TEST(Motion, AnotherViewBeginsAnew) {
    Scene scene;
    MotionFinder finder;
    for (double time = 0.0; time < 3.0; time += 0.2) (void)finder.look(scene.at(time, false), at(time));
    cv::Mat other(240, 320, CV_8UC1, cv::Scalar(60));
    cv::circle(other, {100, 100}, 80, 200, cv::FILLED);
    for (double time = 3.0; time < 6.0; time += 0.2) {
        EXPECT_TRUE(finder.look(pictureFrom(noisy(other, 3.0, 7)), at(time)).empty());
    }
}

TEST(Motion, StrangePicturesAreTaken) {
    MotionFinder finder;
    EXPECT_TRUE(finder.look({}, at(0)).empty());
    EXPECT_TRUE(finder.look({10, 10, Picture::Pixel::Grey16, std::vector<std::byte>(200)}, at(1)).empty());
    EXPECT_TRUE(finder.look({10, 10, Picture::Pixel::Grey8, std::vector<std::byte>(7)}, at(2)).empty());
    EXPECT_TRUE(finder.look({1, 1, Picture::Pixel::Grey8, std::vector<std::byte>(1)}, at(3)).empty());
    EXPECT_TRUE(finder.look({1, 1, Picture::Pixel::Rgb8, std::vector<std::byte>(3)}, at(3.5)).empty());
    const std::vector<std::byte> black(100);
    EXPECT_TRUE(finder.look({10, 10, Picture::Pixel::Grey8, black}, at(4)).empty());
    EXPECT_TRUE(finder.look({10, 10, Picture::Pixel::Grey8, black}, at(3)).empty()) << "back in time";
}

}  // namespace
}  // namespace leitstand::test
