#include "widgets/tables/command_buttons.h"

#include <QAction>
#include <QLayout>
#include <QToolButton>

namespace leitstand {

void addCommandButtons(QLayout& row, const std::vector<QAction*>& commands, QWidget& panel) {
    for (QAction* command : commands) {
        auto* button = new QToolButton(&panel);
        button->setObjectName(command->objectName());
        button->setDefaultAction(command);
        button->setText(command->iconText());
        button->setProperty("quiet", true);
        button->setFocusPolicy(Qt::TabFocus);
        row.addWidget(button);
    }
}

}  // namespace leitstand
