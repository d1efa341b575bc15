#include "core/perception/cues/hazard.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core/base/pose.h"
#include "core/perception/pictures/coding/picture_mat.h"

namespace leitstand {
namespace {

enum Colour : std::uint8_t { Red, Orange, Yellow, Green, Blue, White, Black, Grey, ColourCount };

constexpr int Edge = 64;           // side of a straightened placard [px]
constexpr double Filled = 0.82;    // least share of a contour's hull that the square fills
constexpr double SameSign = 0.35;  // contours nearer than this share of their size are one placard
constexpr double Uneven = 0.6;     // greatest difference between its sides in the share of black along them
constexpr double Framed = 0.7;     // least share of its edge in the colour of its ground or of an edge line

/// Shares of colours in a part of a placard.
struct Shares {
    std::array<double, ColourCount> of{};
    int pixels = 0;
    void add(Colour colour) {
        ++pixels;
        of[colour] += 1.0;
    }
    void close() {
        for (double& one : of) one /= std::max(1, pixels);
    }
    /// The colour of the ground: black may only be drawn on it.
    [[nodiscard]] Colour ground() const {
        if (of[Black] > 0.6) return Black;
        std::size_t best = Red;
        for (std::size_t i = 0; i < ColourCount; ++i) {
            if (i != Black && of[i] > of[best]) best = i;
        }
        return static_cast<Colour>(best);
    }
};

using Corners = std::array<cv::Point2f, 4>;

/// Whether @p corners are all within a picture of that size: beyond its border a placard may have any shape.
bool isWhole(const Corners& corners, const cv::Size& size) {
    return std::all_of(corners.begin(), corners.end(), [&](const cv::Point2f& corner) {
        return corner.x > 1.0F && corner.y > 1.0F && corner.x < static_cast<float>(size.width - 2) &&
               corner.y < static_cast<float>(size.height - 2);
    });
}

/// Returns top, right, bottom and left of a square that stands on a corner; empty for other shapes.
std::optional<Corners> standing(const std::vector<cv::Point>& polygon, const HazardSettings& settings) {
    if (polygon.size() != 4 || !cv::isContourConvex(polygon)) return std::nullopt;
    Corners corners;
    std::size_t top = 0;
    for (std::size_t i = 1; i < 4; ++i) {
        if (polygon[i].y < polygon[top].y) top = i;
    }
    for (std::size_t i = 0; i < 4; ++i) corners[i] = polygon[(top + i) % 4];
    if (corners[1].x < corners[3].x) std::swap(corners[1], corners[3]);
    const cv::Point2f down = corners[2] - corners[0], across = corners[1] - corners[3];
    const double height = std::hypot(down.x, down.y), width = std::hypot(across.x, across.y);
    if (height < settings.smallest || width < settings.smallest) return std::nullopt;
    if (std::max(height, width) > settings.stretch * std::min(height, width)) return std::nullopt;
    const double lean = degrees(settings.lean);
    if (std::abs(std::atan2(down.x, down.y)) > lean) return std::nullopt;
    if (std::abs(std::atan2(across.y, across.x)) > lean) return std::nullopt;
    // The middles of its diagonals are close together: no kite, no arrow.
    const cv::Point2f middle = 0.5F * (corners[0] + corners[2]), other = 0.5F * (corners[1] + corners[3]);
    if (std::hypot(middle.x - other.x, middle.y - other.y) > 0.15 * std::min(height, width))
        return std::nullopt;
    return corners;
}

Colour colourOf(const cv::Vec3b& hsv, double brightest) {
    const double value = hsv[2] / brightest, saturation = hsv[1] / 255.0;
    const int hue = hsv[0];  // half degrees
    if (value < 0.33) return Black;
    if (saturation < 0.3) return value > 0.6 ? White : Grey;
    if (saturation < 0.42) return Grey;
    if (hue < 7 || hue > 168) return Red;
    if (hue < 19) return Orange;
    if (hue < 36) return saturation > 0.5 ? Yellow : Grey;
    if (hue < 92) return Green;
    if (hue < 130) return Blue;
    return Grey;
}

/// Colours of the upper and the lower half, of their parts around the pictogram, and of the edge.
struct Parts {
    Shares upper, lower, upperRim, lowerRim, edge;
    std::array<Shares, 4> sides;  ///< of the edge
};

Parts partsOf(const cv::Mat& rgb, const Corners& corners) {
    const float middle = Edge / 2.0F;
    const Corners straight = {cv::Point2f(middle, 0), cv::Point2f(Edge, middle), cv::Point2f(middle, Edge),
                              cv::Point2f(0, middle)};
    cv::Mat patch, hsv;
    const cv::Mat warp = cv::getPerspectiveTransform(corners.data(), straight.data());
    cv::warpPerspective(rgb, patch, warp, {Edge, Edge}, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    cv::cvtColor(patch, hsv, cv::COLOR_RGB2HSV);
    std::vector<int> values;
    for (int y = 0; y < Edge; ++y) {
        for (int x = 0; x < Edge; ++x) values.push_back(hsv.at<cv::Vec3b>(y, x)[2]);
    }
    const auto bright =
        values.begin() + static_cast<std::ptrdiff_t>(0.9 * static_cast<double>(values.size()));
    std::nth_element(values.begin(), bright, values.end());
    const double brightest = std::max(30, *bright);
    Parts parts;
    for (int y = 0; y < Edge; ++y) {
        for (int x = 0; x < Edge; ++x) {
            const double across = std::abs(x + 0.5 - Edge / 2.0), down = y + 0.5 - Edge / 2.0;
            const double out = (across + std::abs(down)) / (Edge / 2.0);  // 1 on the edge
            const Colour colour = colourOf(hsv.at<cv::Vec3b>(y, x), brightest);
            const bool upper = down<-3.0, lower = down> 3.0;
            if (out > 0.84 && out < 0.98) {
                parts.edge.add(colour);
                parts.sides[(x < Edge / 2 ? 0U : 1U) + (y < Edge / 2 ? 0U : 2U)].add(colour);
            }
            if (out > 0.6 && out < 0.9 && upper) parts.upperRim.add(colour);
            if (out > 0.6 && out < 0.9 && lower) parts.lowerRim.add(colour);
            if (out < 0.8 && upper) parts.upper.add(colour);
            if (out < 0.8 && lower) parts.lower.add(colour);
        }
    }
    for (Shares* one : {&parts.upper, &parts.lower, &parts.upperRim, &parts.lowerRim, &parts.edge})
        one->close();
    for (Shares& side : parts.sides) side.close();
    return parts;
}

struct Meaning {
    Colour upper, lower;
    const char* name;
};
constexpr std::array<Meaning, 10> Meanings = {{{Orange, Orange, "explosive"},
                                               {Red, Red, "flammable"},
                                               {Green, Green, "gas"},
                                               {Blue, Blue, "wet"},
                                               {White, Red, "combustible"},
                                               {Yellow, Yellow, "oxidizer"},
                                               {Red, Yellow, "peroxide"},
                                               {White, White, "poison or infectious"},
                                               {Yellow, White, "radioactive"},
                                               {White, Black, "corrosive"}}};

/// Returns the name and confidence of a placard with these parts.
std::pair<std::string, double> meaningOf(const Parts& parts) {
    const Colour upper = parts.upperRim.ground(), lower = parts.lowerRim.ground();
    // Drawings are black; on red, green and blue they may be white.
    const auto drawnOn = [](const Shares& part, Colour ground) {
        const bool white = ground == Red || ground == Green || ground == Blue;
        return (ground == Black ? 0.0 : part.of[Black]) + (white ? part.of[White] : 0.0);
    };
    const double drawn = drawnOn(parts.upper, upper);  // the pictogram
    double sure =
        std::min(parts.upper.of[upper] + drawn, parts.lower.of[lower] + drawnOn(parts.lower, lower));
    if (upper == White && lower == White) {
        if (drawn < 0.06 || drawn > 0.65) return {{}, 0.0};  // an empty sheet, or a hole
        if (parts.edge.of[Red] > 0.4) return {"GHS", sure};
        // A black line frames it, as it frames many tiles.
        return {"poison or infectious", parts.lower.of[Black] > 0.4 ? 0.0 : 0.75 * sure};
    }
    if (upper == White && drawn < 0.03) sure *= 0.6;
    // Each has a symbol in its upper half: a patch of one colour without a symbol is some object.
    if (upper == lower && drawn < 0.03) return {{}, 0.0};
    // A placard reaches to its very edge; clothes that happen to lie square do not.
    double edge = parts.edge.of[upper] + (upper == lower ? 0.0 : parts.edge.of[lower]);
    edge += std::max(drawnOn(parts.edge, upper), drawnOn(parts.edge, lower));
    if (edge < Framed) return {{}, 0.0};
    // A line runs along all sides or none: black along only some of them is an object beside it.
    const auto [least, most] =
        std::minmax_element(parts.sides.begin(), parts.sides.end(),
                            [](const Shares& a, const Shares& b) { return a.of[Black] < b.of[Black]; });
    if (lower != Black && most->of[Black] - least->of[Black] > Uneven) return {{}, 0.0};
    for (const Meaning& one : Meanings) {
        if (one.upper == upper && one.lower == lower) return {one.name, sure};
    }
    return {{}, 0.0};
}

void take(const cv::Mat& rgb, const Corners& corners, const HazardSettings& settings,
          std::vector<HazardPlacard>& found) {
    const auto [name, confidence] = meaningOf(partsOf(rgb, corners));
    if (confidence < settings.leastConfidence) return;
    HazardPlacard sign;
    sign.name = name;
    sign.confidence = confidence;
    for (std::size_t i = 0; i < 4; ++i) {
        sign.corners[i] = {static_cast<double>(corners[i].x) + 0.5, static_cast<double>(corners[i].y) + 0.5};
        sign.centre += sign.corners[i] / 4.0;
    }
    sign.size = ((sign.corners[2] - sign.corners[0]).norm() + (sign.corners[1] - sign.corners[3]).norm()) / 2;
    for (HazardPlacard& one : found) {
        if ((one.centre - sign.centre).norm() > SameSign * std::max(one.size, sign.size)) continue;
        // The outer contour holds all of it. One that is not surer is the same placard, seen from within.
        if (sign.confidence > one.confidence + 0.05 || (sign.size > one.size && sign.name == one.name))
            one = sign;
        return;
    }
    found.push_back(sign);
}

void look(const cv::Mat& rgb, const cv::Mat& binary, const HazardSettings& settings,
          std::vector<HazardPlacard>& found) {
    std::vector<std::vector<cv::Point>> contours;
    cv::findContours(binary, contours, cv::RETR_LIST, cv::CHAIN_APPROX_SIMPLE);
    for (const auto& contour : contours) {
        if (contour.size() < 4) continue;
        const cv::Rect box = cv::boundingRect(contour);
        if (box.width < settings.smallest || box.height < settings.smallest) continue;
        std::vector<cv::Point> hull, polygon;
        cv::convexHull(contour, hull);
        cv::approxPolyDP(hull, polygon, 0.05 * cv::arcLength(hull, true), true);
        // Discs approximate to four corners too.
        if (cv::contourArea(polygon) < Filled * cv::contourArea(hull)) continue;
        const auto corners = standing(polygon, settings);
        if (corners && isWhole(*corners, rgb.size())) take(rgb, *corners, settings, found);
    }
}

}  // namespace

std::vector<HazardPlacard> findHazards(const Picture& picture, const HazardSettings& settings) {
    const cv::Mat rgb = matOf(picture);
    std::vector<HazardPlacard> found;
    if (rgb.empty() || rgb.channels() != 3 || rgb.cols < 16 || rgb.rows < 16) return found;
    cv::Mat grey, soft, edges, hsv;
    cv::cvtColor(rgb, grey, cv::COLOR_RGB2GRAY);
    cv::GaussianBlur(grey, soft, {3, 3}, 0.0);
    cv::Canny(soft, edges, 40, 110);
    cv::dilate(edges, edges, cv::Mat::ones(2, 2, CV_8U));
    look(rgb, edges, settings, found);
    cv::Mat local;
    cv::adaptiveThreshold(soft, local, 255, cv::ADAPTIVE_THRESH_MEAN_C, cv::THRESH_BINARY_INV, 31, 8);
    look(rgb, local, settings, found);
    // Placards without a line around them stand out by their colour.
    cv::cvtColor(rgb, hsv, cv::COLOR_RGB2HSV);
    cv::Mat vivid;
    cv::extractChannel(hsv, vivid, 1);
    cv::threshold(vivid, vivid, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
    look(rgb, vivid, settings, found);
    std::stable_sort(found.begin(), found.end(), [](const HazardPlacard& a, const HazardPlacard& b) {
        return a.confidence > b.confidence;
    });
    return found;
}

}  // namespace leitstand
