#include "core/perception/pictures/contrast.h"

#include <array>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace leitstand {
namespace {

constexpr int Tiles = 8;  ///< per side, each with its own histogram

struct Strength {
    double gamma, clip;
};

Strength strengthOf(ContrastHelp help) {
    return help == ContrastHelp::Strong ? Strength{0.5, 4.0} : Strength{0.8, 2.0};
}

void raise(cv::Mat& brightness, const Strength& strength) {
    std::array<unsigned char, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double share = static_cast<double>(i) / 255.0;
        table[i] = static_cast<unsigned char>(std::lround(255.0 * std::pow(share, strength.gamma)));
    }
    cv::LUT(brightness, cv::Mat(1, 256, CV_8U, table.data()), brightness);
    cv::createCLAHE(strength.clip, {Tiles, Tiles})->apply(brightness, brightness);
}

}  // namespace

Picture withContrast(const Picture& picture, ContrastHelp help) {
    const bool colour = picture.pixel == Picture::Pixel::Rgb8;
    const auto pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    if (help == ContrastHelp::Off || (!colour && picture.pixel != Picture::Pixel::Grey8) ||
        picture.width < Tiles || picture.height < Tiles ||
        picture.bytes.size() != pixels * picture.pixelSize()) {
        return picture;
    }
    Picture made = picture;
    cv::Mat mat(made.height, made.width, colour ? CV_8UC3 : CV_8UC1, made.bytes.data());
    if (!colour) {
        raise(mat, strengthOf(help));
        return made;
    }
    cv::Mat apart, brightness;
    cv::cvtColor(mat, apart, cv::COLOR_RGB2YCrCb);
    cv::extractChannel(apart, brightness, 0);
    raise(brightness, strengthOf(help));
    cv::insertChannel(brightness, apart, 0);
    cv::cvtColor(apart, mat, cv::COLOR_YCrCb2RGB);
    return made;
}

}  // namespace leitstand
