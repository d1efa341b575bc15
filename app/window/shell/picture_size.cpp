#include "app/window/shell/picture_size.h"

#include <algorithm>
#include <cmath>

#include <QPixmap>
#include <QWidget>

namespace leitstand {
namespace {

constexpr QSize UsualSize(1280, 800);
constexpr double Exact = 1e-6;  ///< a quotient so much above a whole number is that number

int units(int pixels, double scale) {
    return static_cast<int>(std::ceil(pixels / scale - Exact));
}

}  // namespace

QSize windowSizeFor(const std::optional<QSize>& pixels, double scale) {
    if (!pixels) return UsualSize;
    return {units(pixels->width(), scale), units(pixels->height(), scale)};
}

QImage cutToSize(const QImage& picture, const std::optional<QSize>& pixels, double scale) {
    if (!pixels) return picture;
    const QSize most(static_cast<int>(std::lround(windowSizeFor(pixels, scale).width() * scale)),
                     static_cast<int>(std::lround(windowSizeFor(pixels, scale).height() * scale)));
    const auto side = [](int there, int largest, int wanted) {
        return there > largest ? there : std::min(there, wanted);
    };
    const QSize size(side(picture.width(), most.width(), pixels->width()),
                     side(picture.height(), most.height(), pixels->height()));
    return size == picture.size() ? picture : picture.copy(QRect(QPoint(0, 0), size));
}

QImage pictureOf(QWidget& window, const std::optional<QSize>& pixels) {
    return cutToSize(window.grab().toImage(), pixels, window.devicePixelRatioF());
}

}  // namespace leitstand
