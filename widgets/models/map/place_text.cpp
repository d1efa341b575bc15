#include "widgets/models/map/place_text.h"

#include <QCoreApplication>
#include <QStringList>

#include "core/event/map_samples.h"
#include "core/mapping/live/scan_doubts.h"
#include "core/mapping/placement/placement_format.h"
#include "widgets/models/map/doubt_text.h"
#include "widgets/models/numbers.h"

namespace leitstand {
namespace {

struct PlaceTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::RobotMark)
};

/// Translates a doubt that inWords() lists; returns any other word as it is.
QString doubtOf(const QString& word) {
    for (unsigned bit = 1; bit < 256; bit *= 2) {
        const auto doubt = static_cast<std::uint8_t>(bit);
        if (word == QString::fromStdString(inWords(doubt))) return doubtText(doubt);
    }
    return word;
}

}  // namespace

QString howText(const std::string& how) {
    const std::string known = placement_format::inWindowsLanguage(how);
    if (known != how) return QString::fromStdString(known);
    QStringList words = QString::fromStdString(how).split(QStringLiteral(", "));
    for (QString& word : words) word = doubtOf(word);
    return words.join(QStringLiteral(", "));
}

QString placeText(const RobotInMap& place) {
    if (!place.placed) return {};
    const QString percent = percentText(place.certainty);
    const QString sure = place.certain ? PlaceTexts::tr("place certain to %1").arg(percent)
                                       : PlaceTexts::tr("place uncertain, %1").arg(percent);
    if (place.how.empty()) return sure;
    return sure + QStringLiteral(": ") + howText(place.how);
}

}  // namespace leitstand
