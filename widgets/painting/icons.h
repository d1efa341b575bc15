#pragma once

#include <QIcon>
#include <QString>

namespace leitstand {

/// Returns the icon with the file name @p name (without .svg) in resources/icons; null: there is none. It is
/// sharp at every scale and follows the theme. It has the application's text colour, the highlight colour
/// while checked, and the muted colour while disabled.
[[nodiscard]] QIcon themedIcon(const QString& name);

}  // namespace leitstand
