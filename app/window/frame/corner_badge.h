#pragma once

class QLabel;
class QString;
class QWidget;

namespace leitstand {

/// Returns a label for a state that the operator must see while it lasts. The label is hidden at first;
/// WindowFrame::addBadge() places it. @p name: object name of the label.
[[nodiscard]] QLabel* makeCornerBadge(QWidget& parent, const QString& name);

}  // namespace leitstand
