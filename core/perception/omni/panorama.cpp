#include "core/perception/omni/panorama.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <opencv2/imgproc.hpp>

#include "core/event/picture_samples.h"

namespace leitstand {
namespace {

constexpr double Round = 2.0 * std::numbers::pi;
constexpr int LeastWidth = 240, GreatestWidth = 2400;

Eigen::Vector3d directionOf(double yaw, double elevation) {
    return {std::cos(elevation) * std::cos(yaw), std::cos(elevation) * std::sin(yaw), std::sin(elevation)};
}

/// Returns as many pixels around as the picture has at the horizon, or at its upper border.
int widthFor(const MeiCamera& camera, const Eigen::Matrix3d& baseInCamera, double highest) {
    constexpr int Parts = 72;
    double around = 0.0;
    for (int i = 0; i < Parts; ++i) {
        const double elevation = std::min(0.0, highest);
        const auto from = camera.project(baseInCamera * directionOf(Round * i / Parts, elevation));
        const auto to = camera.project(baseInCamera * directionOf(Round * (i + 1) / Parts, elevation));
        if (from && to) around += (*to - *from).norm();
    }
    return std::clamp(static_cast<int>(std::lround(around / 4.0)) * 4, LeastWidth, GreatestWidth);
}

int typeOf(Picture::Pixel pixel) {
    switch (pixel) {
        case Picture::Pixel::Grey8:
            return CV_8UC1;
        case Picture::Pixel::Rgb8:
            return CV_8UC3;
        case Picture::Pixel::Grey16:
            return CV_16UC1;
        case Picture::Pixel::Float32:
            return CV_32FC1;
    }
    return CV_8UC1;
}

}  // namespace

double PanoramaShape::yawAt(double x) const {
    return std::numbers::pi - Round * x / std::max(1, width);
}

double PanoramaShape::elevationAt(double y) const {
    return highest + (lowest - highest) * y / std::max(1, height);
}

double PanoramaShape::columnOf(double yaw) const {
    return (std::numbers::pi - std::remainder(yaw, Round)) / Round * width;
}

double PanoramaShape::rowOf(double elevation) const {
    return (elevation - highest) / (lowest - highest) * height;
}

std::optional<Panorama> Panorama::of(const CameraInfoSample& info, int width, int height,
                                     const Pose& cameraInBase, const PanoramaShape& range) {
    const auto camera = MeiCamera::of(info, width, height);
    if (!camera || !(range.highest - range.lowest > degrees(5))) return std::nullopt;
    const Eigen::Matrix3d baseInCamera = cameraInBase.linear().transpose();
    Panorama panorama;
    panorama.m_info = info;
    panorama.m_width = width;
    panorama.m_height = height;
    PanoramaShape& shape = panorama.m_shape = range;
    shape.width = widthFor(*camera, baseInCamera, range.highest);
    shape.height = static_cast<int>(std::lround(shape.width * (range.highest - range.lowest) / Round));
    const std::size_t count = static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.height);
    panorama.m_x.reserve(count);
    panorama.m_y.reserve(count);
    for (int y = 0; y < shape.height; ++y) {
        for (int x = 0; x < shape.width; ++x) {
            const auto pixel =
                camera->project(baseInCamera * directionOf(shape.yawAt(x + 0.5), shape.elevationAt(y + 0.5)));
            panorama.m_x.push_back(pixel ? static_cast<float>(pixel->x()) : -10.0F);
            panorama.m_y.push_back(pixel ? static_cast<float>(pixel->y()) : -10.0F);
        }
    }
    return panorama;
}

bool Panorama::fits(const CameraInfoSample& info, int width, int height) const {
    return width == m_width && height == m_height && info.width == m_info.width &&
           info.height == m_info.height && info.distortionModel == m_info.distortionModel &&
           info.distortion == m_info.distortion && info.intrinsics == m_info.intrinsics;
}

Picture Panorama::unwrapped(const Picture& picture) const {
    const auto pixels = static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height);
    if (picture.width != m_width || picture.height != m_height ||
        picture.bytes.size() != pixels * picture.pixelSize()) {
        return picture;
    }
    Picture made{m_shape.width, m_shape.height, picture.pixel, {}};
    made.bytes.resize(m_x.size() * made.pixelSize());
    // OpenCV only reads the picture and the table.
    const int type = typeOf(picture.pixel);
    const cv::Mat from(m_height, m_width, type, const_cast<std::byte*>(picture.bytes.data()));
    const cv::Mat x(m_shape.height, m_shape.width, CV_32FC1, const_cast<float*>(m_x.data()));
    const cv::Mat y(m_shape.height, m_shape.width, CV_32FC1, const_cast<float*>(m_y.data()));
    cv::Mat to(m_shape.height, m_shape.width, type, made.bytes.data());
    cv::remap(from, to, x, y, cv::INTER_LINEAR, cv::BORDER_CONSTANT);
    return made;
}

std::optional<Eigen::Vector2d> rawPlaceOf(const CameraInfoSample& info, const Pose& cameraInBase, double yaw,
                                          int width, int height, double elevation) {
    const auto camera = MeiCamera::of(info, width, height);
    if (!camera) return std::nullopt;
    const auto pixel = camera->project(cameraInBase.linear().transpose() * directionOf(yaw, elevation));
    if (!pixel) return std::nullopt;
    return Eigen::Vector2d((pixel->x() + 0.5) / width, (pixel->y() + 0.5) / height);
}

}  // namespace leitstand
