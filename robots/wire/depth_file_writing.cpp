#include "robots/wire/depth_file_writing.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "core/event/picture_samples.h"
#include "core/perception/pictures/coding/depth_file.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "core/perception/pictures/coding/picture_png.h"

namespace leitstand {

Result<PictureSample> compressedDepth(const PictureSample& raw) {
    const auto picture = decodePicture(raw);
    if (!picture) return picture.error();
    const auto png = encodePng(*picture, {});
    if (!png) return png.error();
    const auto content = std::make_shared<std::vector<std::byte>>(depth_file::Head + png->size());
    std::copy(png->begin(), png->end(), content->begin() + depth_file::Head);
    PictureSample file;
    file.header = raw.header;
    file.compressed = true;
    file.encoding = raw.encoding + "; compressedDepth png";
    file.content = {content, *content};
    return file;
}

}  // namespace leitstand
