#pragma once

#include <cstring>
#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "core/event/picture_samples.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "tests/support/samples.h"

namespace leitstand::test {

inline std::vector<std::byte> bytesOf(std::initializer_list<int> values) {
    std::vector<std::byte> bytes;
    for (const int value : values) bytes.push_back(static_cast<std::byte>(value));
    return bytes;
}

inline PictureSample rawPicture(const std::string& encoding, int width, int height, std::size_t step,
                                std::vector<std::byte> bytes) {
    PictureSample sample;
    sample.encoding = encoding;
    sample.width = width;
    sample.height = height;
    sample.step = step;
    sample.content = sharedBytes(std::move(bytes));
    return sample;
}

inline PictureSample pictureFile(std::vector<std::byte> bytes) {
    PictureSample sample;
    sample.compressed = true;
    sample.encoding = "jpeg";
    sample.content = sharedBytes(std::move(bytes));
    return sample;
}

/// @p mat (blue, green, red) as a file of the kind that @p ending names.
inline PictureSample pictureFileOf(const cv::Mat& mat, const std::string& ending,
                                   const std::vector<int>& settings = {}) {
    std::vector<unsigned char> bytes;
    cv::imencode(ending, mat, bytes, settings);
    const auto* begin = reinterpret_cast<const std::byte*>(bytes.data());
    return pictureFile({begin, begin + bytes.size()});
}

/// The picture's values of type T.
template <class T = std::uint8_t>
std::vector<T> valuesOf(const Picture& picture) {
    std::vector<T> found(picture.bytes.size() / sizeof(T));
    std::memcpy(found.data(), picture.bytes.data(), picture.bytes.size());
    return found;
}

inline std::string pictureError(const PictureSample& sample, const PictureLimits& limits = {}) {
    const auto picture = decodePicture(sample, limits);
    return picture ? "none" : picture.error().text;
}

}  // namespace leitstand::test
