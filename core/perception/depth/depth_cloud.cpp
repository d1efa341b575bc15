#include "core/perception/depth/depth_cloud.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

#include "core/base/words.h"
#include "core/event/picture_samples.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "core/perception/pictures/pixel_ray.h"

namespace leitstand {
namespace {

constexpr float Millimetre = 0.001F;
constexpr float NoRay = std::numeric_limits<float>::quiet_NaN();

/// Depths of a picture [m], where its pixels are.
class Depths {
public:
    explicit Depths(const Picture& picture)
        : m_data(picture.bytes.data()),
          m_width(static_cast<std::size_t>(picture.width)),
          m_short(picture.pixel == Picture::Pixel::Grey16) {}

    /// 0 where there is none.
    [[nodiscard]] float at(int x, int y) const {
        const std::size_t pixel = static_cast<std::size_t>(y) * m_width + static_cast<std::size_t>(x);
        if (m_short) return static_cast<float>(valueOf<std::uint16_t>(pixel)) * Millimetre;
        const auto depth = valueOf<float>(pixel);
        return std::isfinite(depth) ? depth : 0.0F;
    }

private:
    template <class T>
    [[nodiscard]] T valueOf(std::size_t pixel) const {
        T value;
        std::memcpy(&value, m_data + pixel * sizeof(T), sizeof(T));
        return value;
    }
    const std::byte* m_data;
    std::size_t m_width;
    bool m_short;
};

}  // namespace

void DepthCloud::aim(const CameraInfoSample& camera, const Picture& picture, int step) {
    std::vector<double> calibration(camera.intrinsics.begin(), camera.intrinsics.end());
    calibration.insert(calibration.end(), camera.distortion.begin(), camera.distortion.end());
    calibration.insert(calibration.end(), {double(camera.width), double(camera.height), double(step)});
    if (m_width == picture.width && m_height == picture.height && m_calibration == calibration) return;
    m_width = picture.width;
    m_height = picture.height;
    m_calibration = std::move(calibration);
    m_rays.clear();
    for (int y = step / 2; y < m_height; y += step) {
        for (int x = step / 2; x < m_width; x += step) {
            const auto ray = pixelDirection(camera, {x + 0.5, y + 0.5}, m_width, m_height);
            const bool ahead = ray && ray->z() > 1e-3;
            m_rays.push_back(ahead ? Eigen::Vector2f((ray->head<2>() / ray->z()).cast<float>())
                                   : Eigen::Vector2f(NoRay, NoRay));
        }
    }
}

Result<CloudSample> DepthCloud::of(const PictureSample& sample, const CameraInfoSample& camera) {
    const auto picture = decodePicture(sample);
    if (!picture) return picture.error();
    if (picture->pixel != Picture::Pixel::Grey16 && picture->pixel != Picture::Pixel::Float32)
        return Error{leitstand::fill(
            translate("leitstand::Error", "picture of depths: expected 16UC1 or 32FC1, found \"{}\""),
            sample.encoding)};
    if (!pixelDirection(camera, {0.5 * picture->width, 0.5 * picture->height}, picture->width,
                        picture->height))
        return Error{translate("leitstand::Error",
                               "picture of depths: its camera_info holds no calibration that is known")};
    const double pixels = static_cast<double>(picture->width) * picture->height;
    const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / m_settings.mostPoints))));
    aim(camera, *picture, step);
    const Depths depths(*picture);
    const auto edge = static_cast<float>(m_settings.edge);
    /// Whether the depths at both sides, as far as there are any, lie elsewhere.
    const auto isBetween = [&](float depth, float before, float after) {
        const float apart = edge * depth;
        return std::abs(before - depth) > apart && std::abs(after - depth) > apart;
    };
    CloudSample cloud;
    cloud.header = sample.header;
    std::size_t ray = 0;
    for (int y = step / 2; y < m_height; y += step) {
        for (int x = step / 2; x < m_width; x += step, ++ray) {
            const float depth = depths.at(x, y);
            if (!(depth >= static_cast<float>(m_settings.nearest)) ||
                !(depth <= static_cast<float>(m_settings.farthest)) || !std::isfinite(m_rays[ray].x()))
                continue;
            const auto beside = [&](int dx, int dy) {
                const int u = std::clamp(x + dx, 0, m_width - 1), v = std::clamp(y + dy, 0, m_height - 1);
                return depths.at(u, v);
            };
            if (isBetween(depth, beside(-1, 0), beside(1, 0)) ||
                isBetween(depth, beside(0, -1), beside(0, 1)))
                continue;
            cloud.points.emplace_back(m_rays[ray].x() * depth, m_rays[ray].y() * depth, depth);
        }
    }
    return cloud;
}

}  // namespace leitstand
