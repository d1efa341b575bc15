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
    double celsius = 0.0;  ///< its mean
};

/// Words about warm things in a picture.
struct HeatLabel {
    QRectF box;            ///< where they stand [px]
    QRectF about;          ///< around what they are about [px]
    double celsius = 0.0;  ///< of the hottest of it
    int marks = 0;         ///< how many frames they are about
    bool brief = false;    ///< there was room for brief words only
};

/// Where to write about @p marks within @p area, so that all can be read: no label lies on another nor on
/// what is
/// @p taken, all are within the area, and they keep off the frames as far as there is room. Marks that are
/// near one another for their size are parts of one body and share a label. Where there is no room nearby
/// the words are @p brief; what finds none for them either has none: its frame says enough. @p sizeOf: of
/// the words about so many degrees.
[[nodiscard]] std::vector<HeatLabel> heatLabels(const std::vector<HeatMark>& marks,
                                                const std::function<QSizeF(double celsius)>& sizeOf,
                                                const QRectF& area, const std::vector<QRectF>& taken = {},
                                                const std::optional<QSizeF>& brief = {});

}  // namespace leitstand
