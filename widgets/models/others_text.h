#pragma once

#include <string>
#include <string_view>

#include <QString>
#include <QStringList>

#include "core/base/printable.h"

namespace leitstand {

/// Returns a text of others for a label or a list. It stays on its line and does not turn the direction of
/// our words. Characters that would do so are shown as escapes (\n, \u202e).
[[nodiscard]] inline QString othersText(std::string_view text) {
    return QString::fromStdString(printable(text));
}

/// Does the same for a text that quotes others.
[[nodiscard]] inline QString othersText(const QString& text) {
    return othersText(std::string_view(text.toStdString()));
}

/// Returns a message that may quote others on one line: some of ours have several.
[[nodiscard]] inline QString othersLine(const QString& text) {
    return othersText(text.trimmed().split(QLatin1Char('\n')).join(QStringLiteral(" · ")));
}

}  // namespace leitstand
