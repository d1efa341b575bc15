#include "core/perception/pictures/pixel_ray.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/event/picture_samples.h"

namespace leitstand::test {
namespace {

CameraInfoSample camera() {
    CameraInfoSample info;
    info.width = 320;
    info.height = 240;
    info.distortionModel = "plumb_bob";
    info.distortion = {-0.12, 0.03, 0.001, -0.0005, 0.0};
    info.intrinsics = {277.0, 0, 159.5, 0, 277.0, 119.5, 0, 0, 1};
    return info;
}

TEST(PixelRay, ThereAndBack) {
    for (const int width : {320, 160}) {  // as calibrated, and reduced
        const int height = width * 3 / 4;
        for (double x = 0.5; x < width; x += 20.0) {
            for (double y = 0.5; y < height; y += 20.0) {
                const Eigen::Vector2d pixel(x, y);
                const auto direction = pixelDirection(camera(), pixel, width, height);
                ASSERT_TRUE(direction);
                const auto back = pixelOf(camera(), 3.0 * *direction, width, height);
                ASSERT_TRUE(back);
                EXPECT_LT((*back - pixel).norm(), 0.01) << pixel.transpose();
            }
        }
    }
}

TEST(PixelRay, NothingBehindTheCameraOrWithoutCalibration) {
    EXPECT_FALSE(pixelOf(camera(), {0.1, 0.1, -1.0}, 320, 240));
    EXPECT_FALSE(pixelOf(camera(), {0.1, 0.1, 0.0}, 320, 240));
    EXPECT_FALSE(pixelOf(camera(), {0.1, 0.1, std::numeric_limits<double>::quiet_NaN()}, 320, 240));
    EXPECT_FALSE(pixelOf(camera(), {0.1, 0.1, 1.0}, 0, 0));
    EXPECT_FALSE(pixelOf({}, {0.1, 0.1, 1.0}, 320, 240));
    CameraInfoSample omni = camera();
    omni.distortionModel = "mei";
    EXPECT_FALSE(pixelOf(omni, {0.1, 0.1, 1.0}, 320, 240));
}

}  // namespace
}  // namespace leitstand::test
