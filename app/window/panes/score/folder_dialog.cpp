#include "app/window/panes/score/folder_dialog.h"

#include <QFileDialog>
#include <QMainWindow>

namespace leitstand {

QFileDialog& openFolderDialog(QMainWindow& window, const QString& title) {
    auto* dialog = new QFileDialog(&window, title);
    dialog->setObjectName(QStringLiteral("reportFolder"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QFileDialog::DontUseNativeDialog);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    dialog->setModal(false);
    dialog->show();
    return *dialog;
}

}  // namespace leitstand
