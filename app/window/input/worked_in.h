#pragma once

class QWidget;

namespace leitstand {

/// Returns whether the operator works in @p window now: the window or one of its floating panes has the
/// keyboard. Dialogs do not count.
[[nodiscard]] bool isWorkedIn(const QWidget& window);

/// Returns whether @p widget is a text field, so that letters are typed into it.
[[nodiscard]] bool isWrittenInto(const QWidget& widget);

}  // namespace leitstand
