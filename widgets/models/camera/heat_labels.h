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
    QRectF box;            ///< box around the words [px]
    QRectF about;          ///< box around all frames to which the label belongs [px]
    double celsius = 0.0;  ///< temperature of the hottest of these frames
    int marks = 0;         ///< number of these frames
    bool brief = false;    ///< whether it has the short text, since there was not enough space
};

/// Returns labels for @p marks that can all be read. Labels are within @p area, cover neither each other nor
/// anything @p taken, and avoid frames as far as there is space. Marks whose distance is small for their size
/// are treated as one body and share a label.
/// @p sizeOf: returns the size of a label for a temperature. @p brief: size of the short text, used if there
/// is no space for the label nearby. If there is no space for the short text either, a body gets no label.
[[nodiscard]] std::vector<HeatLabel> heatLabels(const std::vector<HeatMark>& marks,
                                                const std::function<QSizeF(double celsius)>& sizeOf,
                                                const QRectF& area, const std::vector<QRectF>& taken = {},
                                                const std::optional<QSizeF>& brief = {});

}  // namespace leitstand
