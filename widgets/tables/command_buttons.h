#pragma once

#include <vector>

class QAction;
class QLayout;
class QWidget;

namespace leitstand {

/// Adds quiet buttons for @p commands to @p row of @p panel, each with the short text and the object name of
/// its command.
void addCommandButtons(QLayout& row, const std::vector<QAction*>& commands, QWidget& panel);

}  // namespace leitstand
