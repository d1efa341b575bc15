#pragma once

class QLabel;
class QString;
class QWidget;

namespace leitstand {

/// A word for a state that must be in sight all the time, hidden at first; WindowFrame::addBadge() gives it
/// its place. @p name: its object name.
[[nodiscard]] QLabel* makeCornerBadge(QWidget& parent, const QString& name);

}  // namespace leitstand
