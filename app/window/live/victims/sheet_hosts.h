#pragma once

#include <QStringList>

namespace leitstand {

/// The panes in whose room the form of a find opens, where the layout has no place for it: none that a driver
/// looks at (camera, virtual scan, second camera, strip) and not the alarms.
[[nodiscard]] inline QStringList sheetHosts() {
    return {QStringLiteral("map"),    QStringLiteral("link"),  QStringLiteral("scans"),
            QStringLiteral("missed"), QStringLiteral("score"), QStringLiteral("finds"),
            QStringLiteral("compare")};
}

}  // namespace leitstand
