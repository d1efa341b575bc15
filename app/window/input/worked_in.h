#pragma once

class QWidget;

namespace leitstand {

/// Whether the operator works in @p window now: it has the keyboard, or a pane that floats beside it has.
/// Dialogs are something else.
[[nodiscard]] bool isWorkedIn(const QWidget& window);

/// Whether letters that @p widget gets are written into it: it is a field of text.
[[nodiscard]] bool isWrittenInto(const QWidget& widget);

}  // namespace leitstand
