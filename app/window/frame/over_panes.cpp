#include "app/window/frame/over_panes.h"

#include <QDialog>

#include "app/window/frame/pane_docks.h"

namespace leitstand {

void showOverPanes(QDialog& dialog, const PaneDocks& panes) {
    if (!dialog.isVisible()) {
        dialog.resize(dialog.size().boundedTo(panes.size()));
        dialog.move(panes.mapToGlobal(QPoint((panes.width() - dialog.width()) / 2, 0)));
    }
    dialog.show();
    dialog.raise();
    dialog.activateWindow();
}

}  // namespace leitstand
