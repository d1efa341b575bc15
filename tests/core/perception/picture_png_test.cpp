#include "core/perception/pictures/coding/picture_png.h"

#include <algorithm>
#include <cstring>
#include <string>

#include <gtest/gtest.h>

#include "core/event/picture_samples.h"
#include "core/perception/pictures/coding/picture_decoding.h"

namespace leitstand {
namespace {

Picture sample(Picture::Pixel pixel, int width, int height) {
    Picture picture{width, height, pixel, {}};
    const std::size_t count = static_cast<std::size_t>(width * height) * picture.pixelSize();
    for (std::size_t i = 0; i < count; ++i) picture.bytes.push_back(static_cast<std::byte>(31 * i % 251));
    return picture;
}

Result<Picture> read(const std::vector<std::byte>& file) {
    PictureSample sample;
    sample.compressed = true;
    sample.encoding = "png";
    sample.content = {std::make_shared<const std::vector<std::byte>>(file), file};
    return decodePicture(sample);
}

TEST(PicturePng, KeepsEveryValueAndItsWords) {
    for (const auto pixel : {Picture::Pixel::Grey8, Picture::Pixel::Rgb8, Picture::Pixel::Grey16}) {
        const Picture picture = sample(pixel, 7, 5);
        const auto file = encodePng(picture, {{"Title", "Kürt"}, {"Stamp", "1.5"}});
        ASSERT_TRUE(file.ok()) << file.error().text;
        const auto back = read(*file);
        ASSERT_TRUE(back.ok()) << back.error().text;
        EXPECT_EQ(back->bytes, picture.bytes);
        const std::string text(reinterpret_cast<const char*>(file->data()), file->size());
        EXPECT_NE(text.find("Kürt"), std::string::npos);
        EXPECT_LT(text.find("Stamp"), text.find("IDAT"));
    }
}

TEST(PicturePng, RefusesWhatIsNone) {
    EXPECT_FALSE(encodePng({}).ok());
    EXPECT_FALSE(encodePng(sample(Picture::Pixel::Float32, 2, 2)).ok());
    Picture damaged = sample(Picture::Pixel::Rgb8, 4, 4);
    damaged.bytes.pop_back();
    EXPECT_FALSE(encodePng(damaged).ok());
}

}  // namespace
}  // namespace leitstand
