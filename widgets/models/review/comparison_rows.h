#pragma once

#include <vector>

#include <QString>
#include <QStringList>

#include "core/mapping/comparison/map_comparison.h"

namespace leitstand {

/// Texts of a table, with what each row means.
struct TextTable {
    struct Row {
        QStringList cells;
        QString hint = {};
        friend bool operator==(const Row&, const Row&) = default;
    };
    QStringList header;
    std::vector<Row> rows;
};

/// What both maps of @p comparison are in figures: a row a figure, columns figure, as recorded, registered
/// again. Errors against the truth only where it is known.
[[nodiscard]] TextTable figuresOf(const MapComparison& comparison);
/// A row for each key scan: how well it meets the one before it in both maps, and how far it moved.
[[nodiscard]] TextTable scansOf(const MapComparison& comparison);

/// "moved 12.3 mm at most".
[[nodiscard]] QString movedText(const MapComparison& comparison);
/// "13 key scans · moved 12.3 mm at most": for who hears that the comparison is done.
[[nodiscard]] QString comparedText(const MapComparison& comparison);

}  // namespace leitstand
