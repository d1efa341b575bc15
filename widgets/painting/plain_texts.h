#pragma once

#include <QString>

namespace leitstand {

/// From now on every label and tooltip of the application shows text as it is. Qt takes what looks like HTML
/// for rich text otherwise, and names that robots, people and files bring along would draw, hide, or load
/// pictures. A label that is meant to be rich says so (QLabel::setTextFormat), and escapes what it quotes.
/// Each window calls it; later calls do nothing. Needs a QApplication.
void keepTextsPlain();

/// @p text for a tooltip, broken where a line gets longer than @p letters: plain ones are not broken by Qt.
[[nodiscard]] QString inLines(const QString& text, int letters = 90);

}  // namespace leitstand
