#pragma once

#include <QIcon>
#include <QString>

namespace leitstand {

/// The icon resources/icons/@p name.svg, drawn crisp at every scale in the application's text colour, in its
/// highlight colour while checked, muted while disabled; follows the theme.
[[nodiscard]] QIcon themedIcon(const QString& name);

}  // namespace leitstand
