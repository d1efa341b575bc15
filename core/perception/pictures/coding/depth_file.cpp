#include "core/perception/pictures/coding/depth_file.h"

#include "core/base/words.h"
#include "core/event/picture_samples.h"
#include "core/perception/pictures/coding/picture_file.h"

namespace leitstand::depth_file {

bool isDepth(std::string_view encoding) {
    return encoding.find("compressedDepth") != std::string_view::npos;
}

bool isRvl(std::string_view encoding) {
    return encoding.find("rvl") != std::string_view::npos;
}

Result<void> check(const PictureSample& sample) {
    const auto bytes = sample.content.bytes;
    const std::size_t least = Head + (isRvl(sample.encoding) ? RvlHead : 1);
    if (bytes.size() < least)
        return Error{leitstand::fill(
            translate("leitstand::Error", "picture of depths: expected at least {} bytes, found {}"), least,
            bytes.size())};
    if (!isRvl(sample.encoding) && pictureFileKind(bytes.subspan(Head)) != PictureFileKind::Png)
        return Error{leitstand::fill(
            translate(
                "leitstand::Error",
                "picture of depths: expected a PNG after 12 bytes, found {} other bytes (format \"{}\")"),
            bytes.size(), sample.encoding.substr(0, 40))};
    return {};
}

}  // namespace leitstand::depth_file
