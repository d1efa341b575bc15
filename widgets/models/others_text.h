#pragma once

#include <string>
#include <string_view>

#include <QString>
#include <QStringList>

#include "core/base/printable.h"

namespace leitstand {

/// What others named or said, for a label or a list: it stays on its line and turns the direction of none of
/// our words; characters that would are shown as escapes (\n, \u202e).
[[nodiscard]] inline QString othersText(std::string_view text) {
    return QString::fromStdString(printable(text));
}

/// The same for a text in which others are quoted.
[[nodiscard]] inline QString othersText(const QString& text) {
    return othersText(std::string_view(text.toStdString()));
}

/// A message in which others may be quoted, on one line: some of ours have several.
[[nodiscard]] inline QString othersLine(const QString& text) {
    return othersText(text.trimmed().split(QLatin1Char('\n')).join(QStringLiteral(" · ")));
}

}  // namespace leitstand
