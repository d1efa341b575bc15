#include "core/perception/heat/heat.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/event/picture_samples.h"

namespace leitstand {
namespace {

using Mask = std::vector<char>;

/// Angle of a pixel, as the camera sees it [rad].
Eigen::Vector2d pixelAngles(const CameraInfoSample& camera, const ThermalPicture& picture) {
    const double fx = camera.intrinsics[0], fy = camera.intrinsics[4];
    if (fx > 0.0 && fy > 0.0 && camera.width > 0 && camera.height > 0) {
        return {static_cast<double>(camera.width) / picture.width / fx,
                static_cast<double>(camera.height) / picture.height / fy};
    }
    const double angle = std::numbers::pi / 4.0 / picture.width;
    return {angle, angle};
}

/// The pixels within @p reach of those of @p mask.
Mask grown(const Mask& mask, int width, int height, int reach) {
    Mask result(mask.size(), 0);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (mask[static_cast<std::size_t>(y * width + x)] == 0) continue;
            for (int v = std::max(0, y - reach); v <= std::min(height - 1, y + reach); ++v) {
                for (int u = std::max(0, x - reach); u <= std::min(width - 1, x + reach); ++u)
                    result[static_cast<std::size_t>(v * width + u)] = 1;
            }
        }
    }
    return result;
}

/// Takes the blob that holds pixel @p start out of @p mask (8 neighbours).
std::vector<int> takeBlob(Mask& mask, int width, int height, int start) {
    std::vector<int> blob = {start};
    mask[static_cast<std::size_t>(start)] = 0;
    for (std::size_t i = 0; i < blob.size(); ++i) {
        const int x = blob[i] % width, y = blob[i] / width;
        for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v) {
            for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u) {
                const int next = v * width + u;
                if (mask[static_cast<std::size_t>(next)] == 0) continue;
                mask[static_cast<std::size_t>(next)] = 0;
                blob.push_back(next);
            }
        }
    }
    return blob;
}

HeatBlob describe(const std::vector<int>& pixels, const ThermalPicture& picture, double ambient,
                  const Eigen::Vector2d& angles) {
    HeatBlob blob;
    blob.left = picture.width;
    blob.top = picture.height;
    blob.pixels = static_cast<int>(pixels.size());
    blob.peak = -300.0;
    double weights = 0.0;
    for (const int pixel : pixels) {
        const int x = pixel % picture.width, y = pixel / picture.width;
        const auto value = static_cast<double>(picture.celsius[static_cast<std::size_t>(pixel)]);
        const double weight = std::max(0.1, value - ambient);
        blob.centre += weight * Eigen::Vector2d(x + 0.5, y + 0.5);
        weights += weight;
        blob.mean += value / blob.pixels;
        blob.peak = std::max(blob.peak, value);
        blob.left = std::min(blob.left, x);
        blob.right = std::max(blob.right, x);
        blob.top = std::min(blob.top, y);
        blob.bottom = std::max(blob.bottom, y);
    }
    blob.centre /= weights;
    blob.width = (blob.right - blob.left + 1) * angles.x();
    blob.height = (blob.bottom - blob.top + 1) * angles.y();
    blob.size = std::sqrt(blob.pixels * angles.x() * angles.y());
    blob.cut = blob.left == 0 || blob.top == 0 || blob.right == picture.width - 1 ||
               blob.bottom == picture.height - 1;
    return blob;
}

/// How sure a blob within the band is a body: of middle temperature, of good size, well filled.
double bodyConfidence(const HeatBlob& blob, const HeatSettings& settings) {
    const double band = settings.hottest - settings.coolest;
    const double middle = std::clamp((blob.peak - settings.coolest) / (0.25 * band), 0.2, 1.0);
    const double seen = std::clamp(blob.size / (3.0 * settings.minSize), 0.3, 1.0);
    const double box = (blob.right - blob.left + 1.0) * (blob.bottom - blob.top + 1.0);
    const double filled = std::clamp(2.0 * blob.pixels / box, 0.3, 1.0);
    const double nearHot = blob.peak > settings.hottest - 1.0 ? 0.6 : 1.0;
    return middle * seen * filled * nearHot;
}

}  // namespace

std::string toString(HeatBlob::Kind kind) {
    switch (kind) {
        case HeatBlob::Kind::Body:
            return "body";
        case HeatBlob::Kind::Lamp:
            return "lamp";
        case HeatBlob::Kind::Heater:
            return "heater";
        case HeatBlob::Kind::Other:
            return "other";
    }
    return "other";
}

double surroundings(const ThermalPicture& picture) {
    std::vector<float> values;
    values.reserve(picture.celsius.size());
    std::copy_if(picture.celsius.begin(), picture.celsius.end(), std::back_inserter(values),
                 [](float value) { return std::isfinite(value); });
    if (values.empty()) return 20.0;
    const auto quarter = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 4);
    std::nth_element(values.begin(), quarter, values.end());
    return static_cast<double>(*quarter);
}

std::vector<HeatBlob> findHeat(const ThermalPicture& picture, const CameraInfoSample& camera,
                               const HeatSettings& settings) {
    const auto count = static_cast<std::size_t>(std::max(0, picture.width)) *
                       static_cast<std::size_t>(std::max(0, picture.height));
    if (count == 0 || picture.celsius.size() != count) return {};
    const Eigen::Vector2d angles = pixelAngles(camera, picture);
    const double ambient = surroundings(picture);
    const double least = std::max(settings.coolest, ambient + settings.contrast);
    Mask hot(count, 0), warm(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
        const auto value = static_cast<double>(picture.celsius[i]);
        hot[i] = value > settings.hottest ? 1 : 0;
        warm[i] = value >= least && value <= settings.hottest ? 1 : 0;
    }
    const Mask halo = grown(hot, picture.width, picture.height, settings.halo);
    for (std::size_t i = 0; i < count; ++i) {
        if (halo[i] != 0) warm[i] = 0;
    }
    std::vector<HeatBlob> blobs;
    for (std::size_t i = 0; i < count; ++i) {
        if (hot[i] == 0) continue;
        HeatBlob blob = describe(takeBlob(hot, picture.width, picture.height, static_cast<int>(i)), picture,
                                 ambient, angles);
        blob.kind = blob.size < settings.lampSize ? HeatBlob::Kind::Lamp : HeatBlob::Kind::Heater;
        blobs.push_back(blob);
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (warm[i] == 0) continue;
        HeatBlob blob = describe(takeBlob(warm, picture.width, picture.height, static_cast<int>(i)), picture,
                                 ambient, angles);
        if (blob.pixels < settings.minPixels) continue;
        const bool body = blob.size >= settings.minSize && blob.size <= settings.maxSize;
        blob.kind = body ? HeatBlob::Kind::Body : HeatBlob::Kind::Other;
        blob.confidence = body ? bodyConfidence(blob, settings) : 0.0;
        blobs.push_back(blob);
    }
    std::stable_sort(blobs.begin(), blobs.end(), [](const HeatBlob& a, const HeatBlob& b) {
        if (a.kind != b.kind) return a.kind < b.kind;
        return a.confidence != b.confidence ? a.confidence > b.confidence : a.size > b.size;
    });
    return blobs;
}

}  // namespace leitstand
