#include "robots/simulation/arena/mesh/sign_pictures.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "robots/simulation/arena/mesh/qr_code.h"

namespace leitstand::simulation {
namespace {

constexpr int Edge = 160;  ///< of hazard signs [px]
constexpr int QuietZone = 4;
constexpr int PixelsOfModule = 6;

const cv::Scalar White(255, 255, 255);
const cv::Scalar Black(15, 15, 15);
const cv::Scalar Red(205, 30, 35);
const cv::Scalar Orange(240, 125, 20);
const cv::Scalar Yellow(245, 210, 20);
const cv::Scalar Green(40, 140, 60);
const cv::Scalar Blue(30, 80, 180);

Texture textureOf(const cv::Mat& picture) {
    Texture texture;
    texture.width = picture.cols;
    texture.height = picture.rows;
    texture.pixels.assign(picture.datastart, picture.dataend);
    return texture;
}

cv::Point at(double x, double y) {
    return {static_cast<int>(std::lround(x * Edge)), static_cast<int>(std::lround(y * Edge))};
}

void polygon(cv::Mat& picture, const std::vector<cv::Point>& corners, const cv::Scalar& colour) {
    cv::fillPoly(picture, std::vector<std::vector<cv::Point>>{corners}, colour, cv::LINE_AA);
}

void diamond(cv::Mat& picture, const cv::Scalar& upper, const cv::Scalar& lower) {
    polygon(picture, {at(0.5, 0.03), at(0.97, 0.5), at(0.03, 0.5)}, upper);
    polygon(picture, {at(0.5, 0.97), at(0.97, 0.5), at(0.03, 0.5)}, lower);
    const std::vector<cv::Point> edge = {at(0.5, 0.06), at(0.94, 0.5), at(0.5, 0.94), at(0.06, 0.5)};
    cv::polylines(picture, std::vector<std::vector<cv::Point>>{edge}, true, Black, 2, cv::LINE_AA);
}

void flame(cv::Mat& picture, const cv::Scalar& colour) {
    polygon(picture,
            {at(0.50, 0.16), at(0.58, 0.26), at(0.60, 0.33), at(0.65, 0.29), at(0.67, 0.40), at(0.62, 0.50),
             at(0.54, 0.54), at(0.46, 0.54), at(0.38, 0.50), at(0.34, 0.41), at(0.37, 0.31), at(0.42, 0.36),
             at(0.44, 0.27)},
            colour);
    cv::line(picture, at(0.33, 0.58), at(0.67, 0.58), colour, 3, cv::LINE_AA);
}

void burst(cv::Mat& picture, const cv::Scalar& colour) {
    std::vector<cv::Point> star;
    for (int i = 0; i < 20; ++i) {
        const double radius = i % 2 == 0 ? 0.2 : 0.09;
        star.push_back(at(0.5 + radius * std::cos(i * 0.31416), 0.36 + radius * std::sin(i * 0.31416)));
    }
    polygon(picture, star, colour);
}

void skull(cv::Mat& picture, const cv::Scalar& ground) {
    cv::line(picture, at(0.34, 0.42), at(0.66, 0.56), Black, 5, cv::LINE_AA);
    cv::line(picture, at(0.66, 0.42), at(0.34, 0.56), Black, 5, cv::LINE_AA);
    cv::ellipse(picture, at(0.5, 0.31), {Edge / 9, Edge / 8}, 0, 0, 360, Black, cv::FILLED, cv::LINE_AA);
    cv::rectangle(picture, at(0.45, 0.38), at(0.55, 0.47), Black, cv::FILLED);
    cv::circle(picture, at(0.46, 0.31), Edge / 40, ground, cv::FILLED, cv::LINE_AA);
    cv::circle(picture, at(0.54, 0.31), Edge / 40, ground, cv::FILLED, cv::LINE_AA);
}

void trefoil(cv::Mat& picture) {
    for (const int start : {-120, 0, 120}) {
        cv::ellipse(picture, at(0.5, 0.35), {Edge / 6, Edge / 6}, 0, start + 60, start + 120, Black,
                    cv::FILLED, cv::LINE_AA);
    }
    cv::circle(picture, at(0.5, 0.35), Edge / 18, Yellow, cv::FILLED, cv::LINE_AA);
    cv::circle(picture, at(0.5, 0.35), Edge / 28, Black, cv::FILLED, cv::LINE_AA);
}

void rings(cv::Mat& picture) {
    for (const double angle : {-1.5708, 0.5236, 2.618}) {
        cv::circle(picture, at(0.5 + 0.09 * std::cos(angle), 0.36 + 0.09 * std::sin(angle)), Edge / 10, Black,
                   4, cv::LINE_AA);
    }
}

void bottle(cv::Mat& picture, const cv::Scalar& colour) {
    cv::rectangle(picture, at(0.44, 0.24), at(0.56, 0.55), colour, cv::FILLED);
    cv::rectangle(picture, at(0.47, 0.17), at(0.53, 0.24), colour, cv::FILLED);
}

void drops(cv::Mat& picture) {
    cv::rectangle(picture, at(0.3, 0.44), at(0.7, 0.5), Black, cv::FILLED);
    for (const double x : {0.4, 0.5, 0.6}) {
        cv::line(picture, at(x, 0.2), at(x, 0.28), Black, 3, cv::LINE_AA);
        cv::circle(picture, at(x, 0.35), 4, Black, cv::FILLED, cv::LINE_AA);
    }
}

struct Hazard {
    std::string name;
    cv::Scalar upper, lower;
    void (*draw)(cv::Mat&);
    std::string number;  ///< class of the United Nations' list
};

const std::vector<Hazard>& hazards() {
    static const std::vector<Hazard> all = {
        {"explosive", Orange, Orange, [](cv::Mat& p) { burst(p, Black); }, "1"},
        {"flammable", Red, Red, [](cv::Mat& p) { flame(p, White); }, "3"},
        {"gas", Green, Green, [](cv::Mat& p) { bottle(p, White); }, "2"},
        {"wet", Blue, Blue, [](cv::Mat& p) { flame(p, White); }, "4"},
        {"combustible", White, Red, [](cv::Mat& p) { flame(p, Black); }, "4"},
        {"oxidizer", Yellow, Yellow,
         [](cv::Mat& p) {
             flame(p, Black);
             cv::circle(p, at(0.5, 0.46), Edge / 14, Yellow, 3, cv::LINE_AA);
         },
         "5"},
        {"poison", White, White, [](cv::Mat& p) { skull(p, White); }, "6"},
        {"infectious", White, White, rings, "6"},
        {"radioactive", Yellow, White, trefoil, "7"},
        {"corrosive", White, Black, drops, "8"},
    };
    return all;
}

Texture hazardPicture(const Hazard& hazard) {
    cv::Mat picture(Edge, Edge, CV_8UC3, cv::Scalar(225, 222, 214));
    diamond(picture, hazard.upper, hazard.lower);
    hazard.draw(picture);
    cv::putText(picture, hazard.number, at(0.455, 0.86), cv::FONT_HERSHEY_SIMPLEX, 0.7,
                hazard.lower == Black ? White : Black, 2, cv::LINE_AA);
    return textureOf(picture);
}

Texture qrPicture(std::string_view text) {
    const auto code = encodeQr(text.substr(0, std::min(text.size(), LongestQrText)));
    const int edge = (code->edge + 2 * QuietZone) * PixelsOfModule;
    Texture texture{edge, edge, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * edge * edge), 240)};
    for (int row = 0; row < edge; ++row) {
        for (int column = 0; column < edge; ++column) {
            const int y = row / PixelsOfModule - QuietZone;
            const int x = column / PixelsOfModule - QuietZone;
            if (x < 0 || y < 0 || x >= code->edge || y >= code->edge || !code->at(y, x)) continue;
            std::fill_n(&texture.pixels[static_cast<std::size_t>(3 * (row * edge + column))], 3,
                        std::uint8_t{12});
        }
    }
    return texture;
}

}  // namespace

Texture signPicture(std::string_view text) {
    constexpr std::string_view Qr = "qr:";
    constexpr std::string_view HazardOf = "hazard:";
    if (text.starts_with(Qr)) return qrPicture(text.substr(Qr.size()));
    if (text.starts_with(HazardOf)) {
        for (const Hazard& hazard : hazards()) {
            if (hazard.name == text.substr(HazardOf.size())) return hazardPicture(hazard);
        }
    }
    return {1, 1, {235, 235, 230}};
}

const std::vector<std::string>& hazardNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (const Hazard& hazard : hazards()) list.push_back(hazard.name);
        return list;
    }();
    return names;
}

}  // namespace leitstand::simulation
