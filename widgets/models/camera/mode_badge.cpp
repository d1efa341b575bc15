#include "widgets/models/camera/mode_badge.h"

#include <algorithm>

#include <QStringList>

namespace leitstand {
namespace {

constexpr int Largest = 18, Least = 11;  ///< fonts [px]
constexpr double MostOfPicture = 0.2;    ///< largest share that the badge covers
constexpr double Below = 8.0;            ///< distance from the upper border, when there is room [px]

/// Space around the text, both sides together [px].
struct Padding {
    double across, down;
};
constexpr Padding Roomy{28.0, 10.0}, Tight{8.0, 2.0};

QString initialsOf(const QString& words) {
    QString initials;
    for (const QString& word : words.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        if (word.front().isLetter()) initials += word.front();
    }
    return initials;
}

}  // namespace

ModeBadge modeBadge(const ModeLabel& mode, const QRectF& open,
                    const std::function<QSizeF(const QString& text, int pixels)>& sizeOf) {
    const auto made = [&](const QString& text, int pixels, const Padding& padding, double below) {
        const QSizeF size = sizeOf(text, pixels) + QSizeF(padding.across, padding.down);
        return ModeBadge{text, pixels, {{open.center().x() - 0.5 * size.width(), open.top() + below}, size}};
    };
    const auto fits = [&](const ModeBadge& badge, double widest) {
        const bool within = badge.box.width() <= widest && badge.box.bottom() <= open.bottom();
        return within &&
               badge.box.width() * badge.box.height() <= MostOfPicture * open.width() * open.height();
    };
    const double widest = std::min(0.6 * open.width(), 320.0);
    for (int pixels = Largest; pixels >= Least; --pixels) {
        const ModeBadge badge = made(mode.text, pixels, Roomy, Below);
        if (fits(badge, widest)) return badge;
    }
    const QString& brief = mode.brief.isEmpty() ? mode.text : mode.brief;
    for (const QString& text : {mode.text, brief, initialsOf(brief)}) {
        const ModeBadge badge = made(text, Least, Tight, 0.0);
        if (fits(badge, open.width())) return badge;
    }
    return {};
}

}  // namespace leitstand
