#pragma once

#include <QString>

namespace leitstand {

/// Makes every label and tooltip of the application show plain text. Otherwise Qt treats text that looks like
/// HTML as rich text. Names from robots, people and files could then draw, hide, or load pictures. If a label
/// needs rich text, its code calls QLabel::setTextFormat and escapes quoted text. Each window calls this;
/// later calls do nothing. Needs a QApplication.
void keepTextsPlain();

/// Returns @p text for a tooltip, divided into lines of at most @p letters characters. Longer words are not
/// divided. This is needed because Qt does not wrap plain tooltips.
[[nodiscard]] QString inLines(const QString& text, int letters = 90);

}  // namespace leitstand
