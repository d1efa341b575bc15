#pragma once

#include <QStringList>
#include <QWidget>

namespace leitstand::test {

/// Texts of @p window that do not fit where they stand: labels, buttons, combo boxes, hints of empty
/// lines, headers of lists, tabs, menus, and what else is painted with dots at its end: cells, panes.
[[nodiscard]] QStringList cutTexts(const QWidget& window);

}  // namespace leitstand::test
