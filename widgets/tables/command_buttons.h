#pragma once

#include <vector>

class QAction;
class QLayout;
class QWidget;

namespace leitstand {

/// Adds quiet buttons for @p commands to @p row of @p panel, each with the short text of its command and
/// named as that is.
void addCommandButtons(QLayout& row, const std::vector<QAction*>& commands, QWidget& panel);

}  // namespace leitstand
