#pragma once

class QFileDialog;
class QMainWindow;
class QString;

namespace leitstand {

/// Opens a dialog that asks for the folder of a report. It is not modal and not the desktop's own, so that
/// STOP, by Esc and by its button, works meanwhile. The dialog deletes itself when it is closed.
QFileDialog& openFolderDialog(QMainWindow& window, const QString& title);

}  // namespace leitstand
