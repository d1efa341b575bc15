#include "core/perception/pictures/contrast.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace leitstand {
namespace {

constexpr int Side = 96;

/// A dark picture with a faint square in its middle, some noise, and every channel @p share of it.
Picture night(Picture::Pixel pixel) {
    Picture picture{Side, Side, pixel, {}};
    std::mt19937 random(3);
    std::uniform_int_distribution<int> noise(-1, 1);
    for (int y = 0; y < Side; ++y) {
        for (int x = 0; x < Side; ++x) {
            const bool inside = std::abs(x - Side / 2) < 12 && std::abs(y - Side / 2) < 12;
            const int value = (inside ? 17 : 12) + noise(random);
            if (pixel == Picture::Pixel::Grey8) {
                picture.bytes.push_back(static_cast<std::byte>(value));
                continue;
            }
            for (const int channel : {value + 6, value, value - 4})
                picture.bytes.push_back(static_cast<std::byte>(channel));
        }
    }
    return picture;
}

double meanAt(const Picture& picture, int left, int top, std::size_t channel = 0) {
    double sum = 0.0;
    for (int y = top; y < top + 16; ++y) {
        for (int x = left; x < left + 16; ++x) {
            const auto at = static_cast<std::size_t>(y * picture.width + x) * picture.pixelSize() + channel;
            sum += static_cast<double>(picture.bytes[at]);
        }
    }
    return sum / 256.0;
}

double contrastOf(const Picture& picture) {
    return meanAt(picture, Side / 2 - 8, Side / 2 - 8) - meanAt(picture, 8, 8);
}

TEST(Contrast, MakesFaintThingsSeenInTheDark) {
    for (const auto pixel : {Picture::Pixel::Grey8, Picture::Pixel::Rgb8}) {
        const Picture raw = night(pixel), kept = raw;
        const double before = contrastOf(raw);
        const Picture gentle = withContrast(raw, ContrastHelp::Gentle);
        const Picture strong = withContrast(raw, ContrastHelp::Strong);
        EXPECT_EQ(raw.bytes, kept.bytes);
        EXPECT_EQ(gentle.width, Side);
        EXPECT_EQ(gentle.pixel, pixel);
        EXPECT_GT(contrastOf(gentle), 1.5 * before);
        EXPECT_GT(contrastOf(strong), 3.0 * before);
        EXPECT_GT(contrastOf(strong), contrastOf(gentle));
        EXPECT_GT(meanAt(strong, 8, 8), 2.0 * meanAt(raw, 8, 8)) << "shadows are lifted";
    }
}

TEST(Contrast, KeepsHues) {
    const Picture strong = withContrast(night(Picture::Pixel::Rgb8), ContrastHelp::Strong);
    EXPECT_GT(meanAt(strong, 40, 40, 0), meanAt(strong, 40, 40, 1)) << "red stays more than green";
    EXPECT_GT(meanAt(strong, 40, 40, 1), meanAt(strong, 40, 40, 2)) << "green than blue";
}

TEST(Contrast, LeavesAloneWhatItIsNotFor) {
    const Picture raw = night(Picture::Pixel::Rgb8);
    EXPECT_EQ(withContrast(raw, ContrastHelp::Off).bytes, raw.bytes);
    const Picture numbers{16, 16, Picture::Pixel::Grey16, std::vector<std::byte>(512, std::byte{7})};
    EXPECT_EQ(withContrast(numbers, ContrastHelp::Strong).bytes, numbers.bytes);
    const Picture damaged{16, 16, Picture::Pixel::Rgb8, std::vector<std::byte>(5)};
    EXPECT_EQ(withContrast(damaged, ContrastHelp::Strong).bytes.size(), 5U);
    EXPECT_TRUE(withContrast({}, ContrastHelp::Strong).bytes.empty());
    const Picture tiny{2, 2, Picture::Pixel::Grey8, std::vector<std::byte>(4)};
    EXPECT_EQ(withContrast(tiny, ContrastHelp::Gentle).bytes, tiny.bytes);
}

}  // namespace
}  // namespace leitstand
