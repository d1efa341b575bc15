#pragma once

class QFileDialog;
class QMainWindow;
class QString;

namespace leitstand {

/// Opens a dialog that asks for the folder of a report. It is neither modal nor the desktop's own dialog, so
/// that STOP (by Esc or its button) works while it is open. The dialog deletes itself when it is closed.
QFileDialog& openFolderDialog(QMainWindow& window, const QString& title);

}  // namespace leitstand
