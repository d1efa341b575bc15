#include "core/perception/pictures/sharpness.h"

#include <gtest/gtest.h>

namespace leitstand {
namespace {

/// Stripes whose edges are @p blur pixels wide.
Picture stripes(int blur) {
    Picture picture;
    picture.width = 640;
    picture.height = 48;
    picture.bytes.resize(640 * 48);
    for (int i = 0; i < 640 * 48; ++i) {
        const int phase = i % 640 % 80;
        const int level = std::clamp(phase < 40 ? phase * 255 / blur : (80 - phase) * 255 / blur, 0, 255);
        picture.bytes[static_cast<std::size_t>(i)] = static_cast<std::byte>(level);
    }
    return picture;
}

TEST(Sharpness, ABlurredPictureIsLessSharp) {
    EXPECT_GT(sharpness(stripes(2)), 2.0 * sharpness(stripes(8)));
    EXPECT_GT(sharpness(stripes(8)), 2.0 * sharpness(stripes(30)));
}

TEST(Sharpness, NothingToSeeIsNotSharp) {
    Picture flat = stripes(2);
    std::fill(flat.bytes.begin(), flat.bytes.end(), std::byte{90});
    EXPECT_EQ(sharpness(flat), 0.0);
    EXPECT_EQ(sharpness(Picture()), 0.0);
    flat.bytes.resize(7);
    EXPECT_EQ(sharpness(flat), 0.0) << "bytes that do not fit the size";
}

}  // namespace
}  // namespace leitstand
