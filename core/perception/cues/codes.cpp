#include "core/perception/cues/codes.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <zbar.h>

#include "core/perception/pictures/coding/picture_mat.h"

namespace leitstand {
namespace {

constexpr std::size_t LongestText = 512;
constexpr int LargestEnlarged = 800;  // wider pictures show small codes large enough [px]
constexpr unsigned long Y800 = 0x30303859;

std::string printable(std::string_view text) {
    std::string kept;
    for (const char one : text.substr(0, LongestText)) {
        const auto byte = static_cast<unsigned char>(one);
        if (byte >= 0x20 && byte != 0x7f) kept += one;
    }
    return kept;
}

double areaOf(const std::array<Eigen::Vector2d, 4>& corners) {
    double twice = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const Eigen::Vector2d &a = corners[i], &b = corners[(i + 1) % 4];
        twice += a.x() * b.y() - b.x() * a.y();
    }
    return std::abs(twice) / 2.0;
}

}  // namespace

struct CodeReader::State {
    zbar::zbar_image_scanner_t* scanner = zbar::zbar_image_scanner_create();

    State() {
        using namespace zbar;
        zbar_image_scanner_set_config(scanner, ZBAR_NONE, ZBAR_CFG_ENABLE, 0);
        zbar_image_scanner_set_config(scanner, ZBAR_QRCODE, ZBAR_CFG_ENABLE, 1);
        zbar_image_scanner_set_config(scanner, ZBAR_NONE, ZBAR_CFG_POSITION, 1);
    }
    ~State() { zbar::zbar_image_scanner_destroy(scanner); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    void read(const cv::Mat& grey, double scale, std::vector<FoundCode>& found);
};

void CodeReader::State::read(const cv::Mat& grey, double scale, std::vector<FoundCode>& found) {
    using namespace zbar;
    const cv::Mat plain = grey.isContinuous() ? grey : grey.clone();
    zbar_image_t* image = zbar_image_create();
    zbar_image_set_format(image, Y800);
    zbar_image_set_size(image, static_cast<unsigned>(plain.cols), static_cast<unsigned>(plain.rows));
    zbar_image_set_data(image, plain.data, plain.total(), nullptr);
    if (zbar_scan_image(scanner, image) > 0) {
        for (const zbar_symbol_t* symbol = zbar_image_first_symbol(image); symbol != nullptr;
             symbol = zbar_symbol_next(symbol)) {
            if (zbar_symbol_get_type(symbol) != ZBAR_QRCODE || zbar_symbol_get_loc_size(symbol) < 4) continue;
            FoundCode code;
            code.text = printable({zbar_symbol_get_data(symbol), zbar_symbol_get_data_length(symbol)});
            const bool known = std::any_of(found.begin(), found.end(),
                                           [&](const FoundCode& one) { return one.text == code.text; });
            if (code.text.empty() || known) continue;
            for (unsigned i = 0; i < 4; ++i) {
                code.corners[i] = Eigen::Vector2d(zbar_symbol_get_loc_x(symbol, i) + 0.5,
                                                  zbar_symbol_get_loc_y(symbol, i) + 0.5) /
                                  scale;
                code.centre += code.corners[i] / 4.0;
            }
            code.size = std::sqrt(areaOf(code.corners));
            found.push_back(std::move(code));
        }
    }
    zbar_image_destroy(image);
}

CodeReader::CodeReader() : m_state(std::make_unique<State>()) {}
CodeReader::~CodeReader() = default;
CodeReader::CodeReader(CodeReader&&) noexcept = default;
CodeReader& CodeReader::operator=(CodeReader&&) noexcept = default;

std::vector<FoundCode> CodeReader::read(const Picture& picture) {
    std::vector<FoundCode> found;
    const cv::Mat grey = greyOf(picture);
    if (grey.empty() || grey.cols < 16 || grey.rows < 16) return found;
    m_state->read(grey, 1.0, found);
    if (grey.cols <= LargestEnlarged) {
        cv::Mat enlarged;
        cv::resize(grey, enlarged, {}, 2.0, 2.0, cv::INTER_CUBIC);
        m_state->read(enlarged, 2.0, found);
    }
    return found;
}

}  // namespace leitstand
