#pragma once

class QLabel;
class QMainWindow;
class QString;

namespace leitstand {

/// A word at the right end of @p window's menu bar for a state that must be in sight all the time, hidden at
/// first; several stand side by side. @p name: its object name.
[[nodiscard]] QLabel* addCornerBadge(QMainWindow& window, const QString& name);

}  // namespace leitstand
