#pragma once

#include <QIcon>
#include <QString>

namespace leitstand {

/// Returns the icon resources/icons/@p name.svg, crisp at every scale. It has the application's text colour,
/// the highlight colour while checked, and is muted while disabled. It follows the theme.
[[nodiscard]] QIcon themedIcon(const QString& name);

}  // namespace leitstand
