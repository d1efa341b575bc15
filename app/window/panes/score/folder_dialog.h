#pragma once

class QFileDialog;
class QMainWindow;
class QString;

namespace leitstand {

/// Asks for the folder of a report, beside the window: not modal and not the desktop's own, so that STOP, by
/// Esc and by its button, works while it is open. Deletes itself when it is closed.
QFileDialog& openFolderDialog(QMainWindow& window, const QString& title);

}  // namespace leitstand
