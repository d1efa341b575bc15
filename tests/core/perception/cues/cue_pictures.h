#pragma once

#include <cstring>
#include <random>
#include <string>

#include <opencv2/core.hpp>

#include "core/perception/pictures/picture.h"

namespace leitstand::test {

/// @p mat: 8 bits, grey or red, green, blue.
inline Picture pictureFrom(const cv::Mat& mat) {
    Picture picture{
        mat.cols, mat.rows, mat.channels() == 3 ? Picture::Pixel::Rgb8 : Picture::Pixel::Grey8, {}};
    const std::size_t row = static_cast<std::size_t>(mat.cols) * mat.elemSize();
    picture.bytes.resize(row * static_cast<std::size_t>(mat.rows));
    for (int y = 0; y < mat.rows; ++y)
        std::memcpy(picture.bytes.data() + static_cast<std::size_t>(y) * row, mat.ptr(y), row);
    return picture;
}

/// @p mat with noise of @p deviation.
inline cv::Mat noisy(const cv::Mat& mat, double deviation, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, deviation);
    cv::Mat result = mat.clone();
    const int values = result.cols * result.channels();
    for (int y = 0; y < result.rows; ++y) {
        auto* row = result.ptr<unsigned char>(y);
        for (int x = 0; x < values; ++x) row[x] = cv::saturate_cast<unsigned char>(row[x] + noise(random));
    }
    return result;
}

}  // namespace leitstand::test
