#pragma once

class QLabel;
class QString;
class QWidget;

namespace leitstand {

/// Returns a hidden label for a state that must be in sight all the time. WindowFrame::addBadge() places it.
/// @p name: its object name.
[[nodiscard]] QLabel* makeCornerBadge(QWidget& parent, const QString& name);

}  // namespace leitstand
