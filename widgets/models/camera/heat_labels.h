#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <QRectF>
#include <QSizeF>

namespace leitstand {

/// A warm thing that is framed in a picture.
struct HeatMark {
    QRectF frame;          ///< [px]
    double celsius = 0.0;  ///< mean of the thing
};

/// A label on warm things in a picture.
struct HeatLabel {
    QRectF box;            ///< around the words [px]
    QRectF about;          ///< around the things that they describe [px]
    double celsius = 0.0;  ///< of the hottest thing
    int marks = 0;         ///< number of frames that they describe
    bool brief = false;    ///< there was only room for brief words
};

/// Returns labels for @p marks within @p area that can all be read. No label covers another one or anything
/// @p taken, and labels keep off the frames as far as there is room. Marks that are near one another for
/// their size are parts of one body and share a label. Without room nearby the words are @p brief. A mark
/// without room for these has no label: its frame is enough. @p sizeOf: size of the words for a temperature.
[[nodiscard]] std::vector<HeatLabel> heatLabels(const std::vector<HeatMark>& marks,
                                                const std::function<QSizeF(double celsius)>& sizeOf,
                                                const QRectF& area, const std::vector<QRectF>& taken = {},
                                                const std::optional<QSizeF>& brief = {});

}  // namespace leitstand
