#include "app/window/panes/messages/messages_feature.h"

#include <QAction>
#include <QMainWindow>

#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/source/moment_source.h"
#include "widgets/messages/messages_panel.h"
#include "widgets/models/message_list_model.h"

namespace leitstand {

MessagesFeature::MessagesFeature(const ViewContext& context)
    : QObject(&context.window),
      // The Delete key belongs to the map in these windows.
      m_panel(new MessagesPanel(context.source.messages(), &context.window, MessagesPanel::Keys::Copy)) {
    m_panel->setObjectName(QStringLiteral("messagesPane"));
    QAction& opens = context.commands.add({.id = QStringLiteral("messages.open"),
                                           .menu = CommandMenu::View,
                                           .text = tr("Me&ssages"),
                                           .hint = tr("All messages so far, the newest last"),
                                           .keys = QKeySequence(Qt::Key_F4)});
    connect(&opens, &QAction::triggered, this, [this, &panes = context.panes] {
        panes.open(QStringLiteral("messages"));
        m_panel->setFocus();
    });
}

}  // namespace leitstand
