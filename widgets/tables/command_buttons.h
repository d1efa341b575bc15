#pragma once

#include <vector>

class QAction;
class QLayout;
class QWidget;

namespace leitstand {

/// Adds a borderless button for each of @p commands to @p row, a layout of @p panel. Each button has the
/// short text (iconText) and the object name of its command.
void addCommandButtons(QLayout& row, const std::vector<QAction*>& commands, QWidget& panel);

}  // namespace leitstand
