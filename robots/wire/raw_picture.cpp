#include "robots/wire/raw_picture.h"

#include <bit>
#include <memory>
#include <utility>

#include "core/event/picture_samples.h"
#include "core/perception/pictures/coding/picture_decoding.h"

namespace leitstand {
namespace {

const char* encodingOf(Picture::Pixel pixel) {
    switch (pixel) {
        case Picture::Pixel::Grey8:
            return "mono8";
        case Picture::Pixel::Rgb8:
            return "rgb8";
        case Picture::Pixel::Grey16:
            return "mono16";
        case Picture::Pixel::Float32:
            return "32FC1";
    }
    return "";
}

}  // namespace

Result<PictureSample> rawPicture(const PictureSample& picture) {
    if (!picture.compressed) return picture;
    auto decoded = decodePicture(picture);
    if (!decoded) return decoded.error();
    const auto pixels = std::make_shared<const Picture>(std::move(decoded).value());
    PictureSample raw;
    raw.header = picture.header;
    raw.encoding = encodingOf(pixels->pixel);
    raw.width = pixels->width;
    raw.height = pixels->height;
    raw.step = static_cast<std::size_t>(pixels->width) * pixels->pixelSize();
    raw.bigEndian = std::endian::native == std::endian::big;
    raw.content = {pixels, pixels->bytes};
    return raw;
}

}  // namespace leitstand
