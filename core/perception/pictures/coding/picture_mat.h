#pragma once

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/perception/pictures/picture.h"

namespace leitstand {

/// Returns the pixels of @p picture without copying them; @p picture must outlive the result. Colours are
/// red, green, blue. Empty for Grey16 and Float32, and when the number of bytes does not fit the size.
[[nodiscard]] inline cv::Mat matOf(const Picture& picture) {
    const bool colours = picture.pixel == Picture::Pixel::Rgb8;
    if (!colours && picture.pixel != Picture::Pixel::Grey8) return {};
    if (picture.width <= 0 || picture.height <= 0) return {};
    const auto bytes = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) *
                       picture.pixelSize();
    if (picture.bytes.size() != bytes) return {};
    // OpenCV only reads it.
    auto* data = const_cast<std::byte*>(picture.bytes.data());
    return {picture.height, picture.width, colours ? CV_8UC3 : CV_8UC1, data};
}

/// Returns @p picture in grey. A grey picture is not copied. Empty in the same cases as matOf().
[[nodiscard]] inline cv::Mat greyOf(const Picture& picture) {
    const cv::Mat mat = matOf(picture);
    if (mat.empty() || mat.channels() == 1) return mat;
    cv::Mat grey;
    cv::cvtColor(mat, grey, cv::COLOR_RGB2GRAY);
    return grey;
}

}  // namespace leitstand
