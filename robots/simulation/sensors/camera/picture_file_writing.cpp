#include "robots/simulation/sensors/camera/picture_file_writing.h"

#include <memory>
#include <stdexcept>

#include <opencv2/imgcodecs.hpp>

namespace leitstand::simulation {
namespace {

constexpr int PngEffort = 3;  ///< of 9: small enough, and fast

SharedBytes file(const char* ending, const cv::Mat& picture, const std::vector<int>& settings) {
    auto bytes = std::make_shared<std::vector<std::uint8_t>>();
    if (!cv::imencode(ending, picture, *bytes, settings)) {
        throw std::runtime_error(std::string("OpenCV cannot write pictures as ") + ending);
    }
    return {bytes, std::as_bytes(std::span(*bytes))};
}

/// Returns a view that is only read: OpenCV has no matrix of constant pixels.
template <class Pixel>
cv::Mat view(const std::vector<Pixel>& pixels, int width, int height, int type) {
    return {height, width, type, const_cast<Pixel*>(pixels.data())};
}

}  // namespace

SharedBytes jpegFile(const std::vector<std::uint8_t>& bgr8, int width, int height, int quality) {
    return file(".jpg", view(bgr8, width, height, CV_8UC3), {cv::IMWRITE_JPEG_QUALITY, quality});
}

SharedBytes pngFile(const std::vector<std::uint16_t>& grey, int width, int height) {
    return file(".png", view(grey, width, height, CV_16UC1), {cv::IMWRITE_PNG_COMPRESSION, PngEffort});
}

}  // namespace leitstand::simulation
