#pragma once

#include <string>
#include <string_view>

#include <QString>
#include <QStringList>

#include "core/base/printable.h"

namespace leitstand {

/// Returns @p text, which comes from robots, people or files, for a label or a list. It can neither break the
/// line nor reverse the direction of other words: such characters become escapes (
/// , \u202e).
[[nodiscard]] inline QString othersText(std::string_view text) {
    return QString::fromStdString(printable(text));
}

/// Does the same for a text that quotes others.
[[nodiscard]] inline QString othersText(const QString& text) {
    return othersText(std::string_view(text.toStdString()));
}

/// Returns @p text, a message of this program that may quote others, on one line. Its line breaks become
/// dots.
[[nodiscard]] inline QString othersLine(const QString& text) {
    return othersText(text.trimmed().split(QLatin1Char('\n')).join(QStringLiteral(" · ")));
}

}  // namespace leitstand
