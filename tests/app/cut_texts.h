#pragma once

#include <QStringList>
#include <QWidget>

namespace leitstand::test {

/// Texts of @p window that do not fit where they stand: labels, buttons, combo boxes, hints of empty
/// lines, headers and cells of lists, tabs, menus.
[[nodiscard]] QStringList cutTexts(const QWidget& window);

}  // namespace leitstand::test
