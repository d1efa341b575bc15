#pragma once

class QWidget;

namespace leitstand {

/// Returns whether the operator is working in @p window: the window or one of its floating panes has the
/// keyboard. Dialogs are not included.
[[nodiscard]] bool isWorkedIn(const QWidget& window);

/// Returns whether @p widget is a text field, into which letters are typed.
[[nodiscard]] bool isWrittenInto(const QWidget& widget);

}  // namespace leitstand
