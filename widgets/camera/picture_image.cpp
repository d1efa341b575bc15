#include "widgets/camera/picture_image.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "core/perception/heat/heat_picture.h"

namespace leitstand {
namespace {

/// Returns the numbers of @p picture as grey, spread from their least to their greatest.
template <class Number>
QImage spread(const Picture& picture) {
    std::vector<Number> numbers(picture.bytes.size() / sizeof(Number));
    std::memcpy(numbers.data(), picture.bytes.data(), numbers.size() * sizeof(Number));
    double least = INFINITY, greatest = -INFINITY;
    for (const Number number : numbers) {
        const auto value = static_cast<double>(number);
        if (!std::isfinite(value)) continue;
        least = std::min(least, value);
        greatest = std::max(greatest, value);
    }
    const double scale = greatest > least ? 255.0 / (greatest - least) : 0.0;
    QImage image(picture.width, picture.height, QImage::Format_Grayscale8);
    for (int y = 0; y < picture.height; ++y) {
        uchar* line = image.scanLine(y);
        for (int x = 0; x < picture.width; ++x) {
            const auto value = static_cast<double>(numbers[static_cast<std::size_t>(y) * picture.width + x]);
            line[x] = std::isfinite(value) ? static_cast<uchar>(std::lround(scale * (value - least))) : 0;
        }
    }
    return image;
}

}  // namespace

QImage imageOf(const Picture& picture) {
    const auto pixels = static_cast<std::size_t>(std::max(0, picture.width)) *
                        static_cast<std::size_t>(std::max(0, picture.height));
    if (pixels == 0 || picture.bytes.size() != pixels * picture.pixelSize()) return {};
    const auto* bytes = reinterpret_cast<const uchar*>(picture.bytes.data());
    switch (picture.pixel) {
        case Picture::Pixel::Grey8:
            return QImage(bytes, picture.width, picture.height, picture.width, QImage::Format_Grayscale8)
                .copy();
        case Picture::Pixel::Rgb8:
            // the format that the painter draws fastest
            return QImage(bytes, picture.width, picture.height, 3 * static_cast<qsizetype>(picture.width),
                          QImage::Format_RGB888)
                .convertToFormat(QImage::Format_RGB32);
        case Picture::Pixel::Grey16:
            return spread<std::uint16_t>(picture);
        case Picture::Pixel::Float32:
            return spread<float>(picture);
    }
    return {};
}

QRgb thermalColour(float celsius, const ThermalRange& range, ThermalPalette palette) {
    if (!std::isfinite(celsius)) return qRgb(96, 96, 96);
    const double width = std::max(0.1F, range.hottest - range.coolest);
    const double share = std::clamp((celsius - range.coolest) / width, 0.0, 1.0);
    if (palette == ThermalPalette::Iron) {
        const auto [red, green, blue] = inferno(share);
        return qRgb(red, green, blue);
    }
    const int grey = static_cast<int>(std::lround(255.0 * share));
    return palette == ThermalPalette::GreyHot ? qRgb(grey, grey, grey)
                                              : qRgb(255 - grey, 255 - grey, 255 - grey);
}

QImage imageOf(const ThermalPicture& picture, const ThermalRange& range, ThermalPalette palette) {
    const auto pixels = static_cast<std::size_t>(std::max(0, picture.width)) *
                        static_cast<std::size_t>(std::max(0, picture.height));
    if (pixels == 0 || picture.celsius.size() != pixels) return {};
    constexpr int Steps = 1024;
    std::vector<QRgb> table(Steps);
    const float width = std::max(0.1F, range.hottest - range.coolest);
    for (int i = 0; i < Steps; ++i) {
        const float celsius = range.coolest + width * static_cast<float>(i) / (Steps - 1);
        table[static_cast<std::size_t>(i)] = thermalColour(celsius, range, palette);
    }
    QImage image(picture.width, picture.height, QImage::Format_RGB32);
    const float* value = picture.celsius.data();
    for (int y = 0; y < picture.height; ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < picture.width; ++x, ++value) {
            const float place = (Steps - 1) * (*value - range.coolest) / width;
            line[x] = std::isfinite(place)
                          ? table[static_cast<std::size_t>(std::clamp(place, 0.0F, Steps - 1.0F))]
                          : thermalColour(*value, range, palette);
        }
    }
    return image;
}

std::optional<float> celsiusAt(const ThermalPicture& picture, double x, double y) {
    if (!(x >= 0.0 && x < 1.0 && y >= 0.0 && y < 1.0)) return std::nullopt;
    const auto column = static_cast<std::size_t>(x * picture.width);
    const auto row = static_cast<std::size_t>(y * picture.height);
    const std::size_t at = row * static_cast<std::size_t>(picture.width) + column;
    if (at >= picture.celsius.size() || !std::isfinite(picture.celsius[at])) return std::nullopt;
    return picture.celsius[at];
}

ThermalRange rangeOf(const ThermalPicture& picture) {
    ThermalRange range{INFINITY, -INFINITY};
    for (const float celsius : picture.celsius) {
        if (!std::isfinite(celsius)) continue;
        range.coolest = std::min(range.coolest, celsius);
        range.hottest = std::max(range.hottest, celsius);
    }
    if (range.coolest > range.hottest) return {};
    const float lacking = std::max(0.0F, 2.0F - (range.hottest - range.coolest));
    return {range.coolest - 0.5F * lacking, range.hottest + 0.5F * lacking};
}

ThermalRange eased(const ThermalRange& before, const ThermalRange& now) {
    constexpr float Share = 0.2F, Much = 10.0F;
    const auto step = [](float from, float to) {
        return std::abs(to - from) > Much ? to : from + Share * (to - from);
    };
    return {step(before.coolest, now.coolest), step(before.hottest, now.hottest)};
}

}  // namespace leitstand
