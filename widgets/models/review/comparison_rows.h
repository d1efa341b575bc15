#pragma once

#include <vector>

#include <QString>
#include <QStringList>

#include "core/mapping/comparison/map_comparison.h"

namespace leitstand {

/// The texts of a table, and the meaning of each row.
struct TextTable {
    struct Row {
        QStringList cells;
        QString hint = {};
        friend bool operator==(const Row&, const Row&) = default;
    };
    QStringList header;
    std::vector<Row> rows;
};

/// Returns the figures of both maps of @p comparison, one per row. Columns: figure, as recorded, registered
/// again. Errors are included only if the truth is known.
[[nodiscard]] TextTable figuresOf(const MapComparison& comparison);
/// Returns a row for each key scan: residual and overlap with the previous key scan in both maps, how far it
/// moved and turned, and whether it is certain.
[[nodiscard]] TextTable scansOf(const MapComparison& comparison);

/// "moved 12.3 mm at most".
[[nodiscard]] QString movedText(const MapComparison& comparison);
/// Returns "13 key scans registered again: moved 12.3 mm at most", the message after a comparison.
[[nodiscard]] QString comparedText(const MapComparison& comparison);

}  // namespace leitstand
