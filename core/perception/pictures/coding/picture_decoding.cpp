#include "core/perception/pictures/coding/picture_decoding.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/words.h"
#include "core/event/picture_samples.h"
#include "core/perception/pictures/coding/depth_decoding.h"
#include "core/perception/pictures/coding/depth_file.h"
#include "core/perception/pictures/coding/picture_cost.h"
#include "core/perception/pictures/coding/picture_encoding.h"

namespace leitstand {
namespace {

using Layout = PictureEncoding::Layout;
constexpr double ZeroCelsius = 273.15;  // [K]

Result<void> checkSize(std::int64_t width, std::int64_t height, const PictureLimits& limits) {
    if (width > 0 && height > 0 && width <= limits.maxSide && height <= limits.maxSide &&
        width * height <= limits.maxPixels) {
        return {};
    }
    return Error{
        leitstand::fill(translate("leitstand::Error",
                                  "picture: expected 1 to {} pixels a side and at most {}, found {} x {}"),
                        limits.maxSide, limits.maxPixels, width, height)};
}

/// The pixels of @p mat, which has one of Picture's own formats.
Picture pictureOf(const cv::Mat& mat, Picture::Pixel pixel) {
    Picture picture{mat.cols, mat.rows, pixel, {}};
    const std::size_t row = static_cast<std::size_t>(mat.cols) * picture.pixelSize();
    picture.bytes.resize(row * static_cast<std::size_t>(mat.rows));
    for (int y = 0; y < mat.rows; ++y) {
        std::memcpy(picture.bytes.data() + static_cast<std::size_t>(y) * row, mat.ptr(y), row);
    }
    return picture;
}

Picture converted(const cv::Mat& from, int code) {
    Picture picture{from.cols, from.rows, Picture::Pixel::Rgb8, {}};
    picture.bytes.resize(static_cast<std::size_t>(from.cols) * static_cast<std::size_t>(from.rows) * 3);
    cv::Mat rgb(from.rows, from.cols, CV_8UC3, picture.bytes.data());
    cv::cvtColor(from, rgb, code);
    CV_Assert(rgb.data == reinterpret_cast<unsigned char*>(picture.bytes.data()));
    return picture;
}

/// OpenCV's code that makes RGB; its Bayer names begin at the second row and column, ROS' at the first.
int conversionCode(Layout layout) {
    switch (layout) {
        case Layout::Bgr:
            return cv::COLOR_BGR2RGB;
        case Layout::Rgba:
            return cv::COLOR_RGBA2RGB;
        case Layout::Bgra:
            return cv::COLOR_BGRA2RGB;
        case Layout::Yuyv:
            return cv::COLOR_YUV2RGB_YUYV;
        case Layout::Uyvy:
            return cv::COLOR_YUV2RGB_UYVY;
        case Layout::BayerRggb:
            return cv::COLOR_BayerBG2RGB;
        case Layout::BayerBggr:
            return cv::COLOR_BayerRG2RGB;
        case Layout::BayerGbrg:
            return cv::COLOR_BayerGR2RGB;
        case Layout::BayerGrbg:
            return cv::COLOR_BayerGB2RGB;
        case Layout::Grey:
        case Layout::Rgb:
        case Layout::Float:
            break;
    }
    return -1;
}

void swapValues(std::vector<std::byte>& bytes, std::size_t size) {
    for (auto at = bytes.begin(); at != bytes.end(); at += static_cast<std::ptrdiff_t>(size)) {
        std::reverse(at, at + static_cast<std::ptrdiff_t>(size));
    }
}

Result<Picture> decodeRaw(const PictureSample& sample, const PictureLimits& limits) {
    const PictureEncoding* encoding = findPictureEncoding(sample.encoding);
    if (encoding == nullptr) {
        return Error{leitstand::fill(
            translate("leitstand::Error", "picture: encoding \"{}\" cannot be shown"), sample.encoding)};
    }
    if (auto size = checkSize(sample.width, sample.height, limits); !size) return size.error();
    const auto width = static_cast<std::size_t>(sample.width);
    const auto height = static_cast<std::size_t>(sample.height);
    const std::size_t row = width * encoding->pixelSize, bytes = sample.content.bytes.size();
    if (sample.step < row || bytes / height < sample.step) {
        return Error{leitstand::fill(
            translate("leitstand::Error",
                      "picture: expected {} rows of at least {} bytes, found {} bytes, {} a row"),
            height, row, bytes, sample.step)};
    }
    // OpenCV only reads it.
    auto* data = const_cast<std::byte*>(sample.content.bytes.data());
    const int channels = static_cast<int>(encoding->pixelSize / encoding->valueSize);
    const int depth = encoding->layout == Layout::Float ? CV_32F : encoding->valueSize == 2 ? CV_16U : CV_8U;
    const cv::Mat mat(sample.height, sample.width, CV_MAKETYPE(depth, channels), data, sample.step);
    if (const int code = conversionCode(encoding->layout); code >= 0) {
        if (encoding->pixelSize == 1 && (width < 3 || height < 3)) {
            return Error{
                translate("leitstand::Error", "picture: expected at least 3 x 3 pixels of a Bayer pattern")};
        }
        if (encoding->pixelSize == 2 && width % 2 != 0) {
            return Error{leitstand::fill(
                translate("leitstand::Error", "picture: expected pairs of pixels in a row, found {}"),
                width)};
        }
        return converted(mat, code);
    }
    Picture picture = pictureOf(mat, encoding->layout == Layout::Float ? Picture::Pixel::Float32
                                     : encoding->layout == Layout::Rgb ? Picture::Pixel::Rgb8
                                     : encoding->valueSize == 2        ? Picture::Pixel::Grey16
                                                                       : Picture::Pixel::Grey8);
    const bool swap = sample.bigEndian != (std::endian::native == std::endian::big);
    if (swap && encoding->valueSize > 1) swapValues(picture.bytes, encoding->valueSize);
    return picture;
}

Result<Picture> decodeFile(const PictureSample& sample, const PictureLimits& limits) {
    const auto affordable = affordableFile(sample.content.bytes, limits);
    if (!affordable) return affordable.error();
    const auto bytes = affordable->bytes;
    const PictureFileSize* size = &affordable->size;
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        return Error{translate("leitstand::Error", "picture: expected a file of less than 2 GB")};
    }
    const cv::Mat file(1, static_cast<int>(bytes.size()), CV_8U, const_cast<std::byte*>(bytes.data()));
    cv::Mat mat = cv::imdecode(file, cv::IMREAD_UNCHANGED | cv::IMREAD_IGNORE_ORIENTATION);
    if (mat.empty() || mat.cols != size->width || mat.rows != size->height) {
        return Error{leitstand::fill(
            translate("leitstand::Error", "picture: the file of {} bytes is damaged"), bytes.size())};
    }
    if (mat.type() == CV_16UC1) return pictureOf(mat, Picture::Pixel::Grey16);
    if (mat.depth() == CV_16U) mat.convertTo(mat, CV_8U, 1.0 / 257.0);
    switch (mat.type()) {
        case CV_8UC1:
            return pictureOf(mat, Picture::Pixel::Grey8);
        case CV_8UC3:
            return converted(mat, cv::COLOR_BGR2RGB);
        case CV_8UC4:
            return converted(mat, cv::COLOR_BGRA2RGB);
        default:
            return Error{leitstand::fill(
                translate("leitstand::Error", "picture: {} channels cannot be shown"), mat.channels())};
    }
}

template <class T>
std::vector<float> celsiusOf(const Picture& picture, const ThermalScale& scale) {
    std::vector<float> celsius(picture.bytes.size() / sizeof(T));
    for (std::size_t i = 0; i < celsius.size(); ++i) {
        T raw;
        std::memcpy(&raw, picture.bytes.data() + i * sizeof(T), sizeof(T));
        const double kelvin = static_cast<double>(raw) * scale.scale + scale.offset;
        celsius[i] = std::isfinite(kelvin) && kelvin >= 0.0 ? static_cast<float>(kelvin - ZeroCelsius)
                                                            : std::numeric_limits<float>::quiet_NaN();
    }
    return celsius;
}

}  // namespace

Result<Picture> decodePicture(const PictureSample& sample, const PictureLimits& limits) {
    if (sample.video) return VideoDecoder(limits.maxVideoPixels).decode(sample.video);
    if (sample.compressed && depth_file::isDepth(sample.encoding)) return decodeDepthFile(sample, limits);
    try {
        return sample.compressed ? decodeFile(sample, limits) : decodeRaw(sample, limits);
    } catch (const cv::Exception& error) {
        return Error{leitstand::fill(translate("leitstand::Error", "picture: {}"), error.what())};
    }
}

Result<Picture> PictureDecoder::decode(const PictureSample& sample, const std::stop_token& stop) {
    return sample.video ? m_video.decode(sample.video, stop) : decodePicture(sample, m_limits);
}

Result<ThermalPicture> temperatures(const Picture& picture, const ThermalScale& scale) {
    if (!scale.measured)
        return Error{
            translate("leitstand::Error", "thermal picture: its colours are mapped and tell no temperature")};
    ThermalPicture thermal{picture.width, picture.height, {}};
    switch (picture.pixel) {
        case Picture::Pixel::Grey8:
            thermal.celsius = celsiusOf<std::uint8_t>(picture, scale);
            break;
        case Picture::Pixel::Grey16:
            thermal.celsius = celsiusOf<std::uint16_t>(picture, scale);
            break;
        case Picture::Pixel::Float32:
            thermal.celsius = celsiusOf<float>(picture, scale);
            break;
        case Picture::Pixel::Rgb8:
            return Error{
                translate("leitstand::Error", "thermal picture: expected one number a pixel, found colours")};
    }
    return thermal;
}

}  // namespace leitstand
