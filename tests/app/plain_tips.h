#pragma once

#include <QStringList>
#include <QWidget>

namespace leitstand::test {

/// What people see of @p window's texts that look like HTML: how many labels and tooltips quote them as they
/// are, and which draw them.
struct QuotedHtml {
    int labels = 0, tips = 0;
    QStringList drawn;
};
/// Looks at every label of @p window that is shown, and asks every widget and the cells of every list for its
/// tooltip, as a mouse does.
[[nodiscard]] QuotedHtml quotedHtml(QWidget& window);

}  // namespace leitstand::test
