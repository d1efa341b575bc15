#include "core/handin/map/map_canvas.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace leitstand {
namespace {

constexpr int Font = cv::FONT_HERSHEY_SIMPLEX;
constexpr double CapitalHeight = 21.0;  ///< of the font at scale 1 [px]

/// Scale and thickness of the font for capitals of a height in pixels.
struct Type {
    double scale = 1.0;
    int thick = 1;
};
Type typeFor(double pixels) {
    const double height = std::max(pixels, 7.0);
    return {height / CapitalHeight, std::max(1, static_cast<int>(std::lround(height / 9.0)))};
}

cv::Scalar scalarOf(Rgb colour) {
    return {double(colour.red), double(colour.green), double(colour.blue)};
}

/// Returns the same pixels as an OpenCV matrix.
cv::Mat matOf(Picture& picture) {
    return {picture.height, picture.width, CV_8UC3, picture.bytes.data()};
}

/// Sixteenths of pixels. OpenCV counts pixels by their middles.
constexpr int Shift = 4;
cv::Point fine(const Eigen::Vector2d& pixel) {
    const auto number = [](double value) {
        return static_cast<int>(std::lround(std::clamp(value - 0.5, -1e6, 1e6) * (1 << Shift)));
    };
    return {number(pixel.x()), number(pixel.y())};
}

}  // namespace

Rgb MapPicture::at(int column, int row) const {
    const std::size_t first = 3U * (static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                                    static_cast<std::size_t>(column));
    return {std::to_integer<std::uint8_t>(picture.bytes[first]),
            std::to_integer<std::uint8_t>(picture.bytes[first + 1]),
            std::to_integer<std::uint8_t>(picture.bytes[first + 2])};
}

void MapCanvas::set(int column, int row, Rgb colour) {
    if (column < 0 || row < 0 || column >= m_map.picture.width || row >= m_map.picture.height) return;
    std::byte* pixel = m_map.picture.bytes.data() +
                       3U * (static_cast<std::size_t>(row) * static_cast<std::size_t>(m_map.picture.width) +
                             static_cast<std::size_t>(column));
    pixel[0] = std::byte{colour.red};
    pixel[1] = std::byte{colour.green};
    pixel[2] = std::byte{colour.blue};
}

/// Sets the pixels whose middle, relative to @p centre [m], is @p inside.
template <class Inside>
void MapCanvas::fill(const Eigen::Vector2d& centre, double reach, Rgb colour, Inside inside) {
    const Eigen::Vector2d middle = m_map.pixelOf(centre);
    if (!middle.allFinite() || middle.cwiseAbs().maxCoeff() > 1e6) return;
    const int most = static_cast<int>(std::ceil(reach / m_map.perPixel)) + 1;
    const int column = static_cast<int>(std::floor(middle.x())),
              row = static_cast<int>(std::floor(middle.y()));
    for (int y = row - most; y <= row + most; ++y) {
        for (int x = column - most; x <= column + most; ++x) {
            const Eigen::Vector2d away = (Eigen::Vector2d(x + 0.5, y + 0.5) - middle) * m_map.perPixel;
            if (inside(away)) set(x, y, colour);
        }
    }
}

void MapCanvas::disc(const Eigen::Vector2d& centre, double across, Rgb colour) {
    fill(centre, across / 2, colour, [&](const Eigen::Vector2d& away) { return away.norm() <= across / 2; });
}

void MapCanvas::diamond(const Eigen::Vector2d& centre, double side, Rgb colour) {
    const double reach = side / std::sqrt(2.0);
    fill(centre, reach, colour, [&](const Eigen::Vector2d& away) { return away.lpNorm<1>() < reach; });
}

void MapCanvas::bar(const Eigen::Vector2d& upperLeft, double along, double down, Rgb colour) {
    const Eigen::Vector2d first = m_map.pixelOf(upperLeft);
    const auto pixels = [&](double length) {
        return std::max(1, static_cast<int>(std::lround(length / m_map.perPixel)));
    };
    const int left = static_cast<int>(std::lround(first.x())), top = static_cast<int>(std::lround(first.y()));
    for (int y = top; y < top + pixels(down); ++y) {
        for (int x = left; x < left + pixels(along); ++x) set(x, y, colour);
    }
}

void MapCanvas::polygon(const std::vector<Eigen::Vector2d>& corners, Rgb colour) {
    std::vector<std::vector<cv::Point>> points(1);
    for (const Eigen::Vector2d& corner : corners) points[0].push_back(fine(m_map.pixelOf(corner)));
    cv::Mat picture = matOf(m_map.picture);
    cv::fillPoly(picture, points, scalarOf(colour), cv::LINE_8, Shift);
}

void MapCanvas::line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double wide, Rgb colour) {
    polyline({from, to}, wide, colour);
}

void MapCanvas::polyline(const std::vector<Eigen::Vector2d>& points, double wide, Rgb colour) {
    constexpr double Piece = 0.5;  // long lines are painted in pieces, to test few pixels [m]
    const double reach = std::max(wide, m_map.perPixel) / 2 * (1.0 + 1e-9);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Eigen::Vector2d whole = points[i] - points[i - 1];
        const double length = whole.norm();
        if (!std::isfinite(length) || length > 1e4) continue;
        const int pieces = std::max(1, static_cast<int>(std::ceil(length / Piece)));
        const Eigen::Vector2d step = whole / pieces;
        // In pixels, right is -y and down is -x.
        const Eigen::Vector2d half(-step.y() / 2, -step.x() / 2);
        for (int piece = 0; piece < pieces; ++piece) {
            const Eigen::Vector2d middle = points[i - 1] + (piece + 0.5) * step;
            fill(middle, half.norm() + reach, colour, [&](const Eigen::Vector2d& away) {
                const double square = half.squaredNorm();
                const double along = square > 0.0 ? std::clamp(away.dot(half) / square, -1.0, 1.0) : 0.0;
                return (away - along * half).norm() <= reach;
            });
        }
    }
}

void MapCanvas::text(const Eigen::Vector2d& lowerLeft, const std::string& text, double height, Rgb colour) {
    const Eigen::Vector2d pixel = m_map.pixelOf(lowerLeft);
    if (!pixel.allFinite() || pixel.cwiseAbs().maxCoeff() > 1e6) return;
    const Type type = typeFor(height / m_map.perPixel);
    cv::Mat picture = matOf(m_map.picture);
    cv::putText(picture, text, {static_cast<int>(pixel.x()), static_cast<int>(pixel.y())}, Font, type.scale,
                scalarOf(colour), type.thick, cv::LINE_8);
}

void MapCanvas::centredText(const Eigen::Vector2d& centre, const std::string& words, double height,
                            Rgb colour) {
    const Type type = typeFor(height / m_map.perPixel);
    int below = 0;
    const cv::Size size = cv::getTextSize(words, Font, type.scale, type.thick, &below);
    const Eigen::Vector2d half(-0.5 * (size.height - type.thick) * m_map.perPixel,
                               0.5 * size.width * m_map.perPixel);
    text(centre + half, words, height, colour);
}

double MapCanvas::textWidth(const std::string& text, double height, double perPixel) {
    const Type type = typeFor(height / perPixel);
    int below = 0;
    return cv::getTextSize(text, Font, type.scale, type.thick, &below).width * perPixel;
}

}  // namespace leitstand
