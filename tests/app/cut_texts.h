#pragma once

#include <QStringList>
#include <QWidget>

namespace leitstand::test {

/// Texts of @p window that do not fit where they stand: labels, buttons, combo boxes, headers of tables,
/// tabs, menus.
[[nodiscard]] QStringList cutTexts(const QWidget& window);

}  // namespace leitstand::test
