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
    double celsius = 0.0;  ///< mean temperature of the thing
};

/// A label on warm things in a picture.
struct HeatLabel {
    QRectF box;            ///< around the words [px]
    QRectF about;          ///< around all frames that the label describes [px]
    double celsius = 0.0;  ///< of the hottest of these frames
    int marks = 0;         ///< number of these frames
    bool brief = false;    ///< there was only room for the brief words
};

/// Returns labels for @p marks that can all be read. Labels lie within @p area, cover neither each other nor
/// anything @p taken, and avoid frames as far as there is room. Marks that are close to each other for their
/// size count as one body and share a label. @p sizeOf: returns the size of a label for a temperature.
/// @p brief: size of the brief words, used when the label has no room nearby. Without room for these either,
/// a body gets no label.
[[nodiscard]] std::vector<HeatLabel> heatLabels(const std::vector<HeatMark>& marks,
                                                const std::function<QSizeF(double celsius)>& sizeOf,
                                                const QRectF& area, const std::vector<QRectF>& taken = {},
                                                const std::optional<QSizeF>& brief = {});

}  // namespace leitstand
