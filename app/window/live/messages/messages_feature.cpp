#include "app/window/live/messages/messages_feature.h"

#include <QAction>
#include <QMainWindow>

#include "app/window/commands/command_table.h"
#include "app/window/live/frame/pane_docks.h"
#include "app/window/live/moment_source.h"
#include "widgets/messages/messages_panel.h"
#include "widgets/models/message_list_model.h"

namespace leitstand {

MessagesFeature::MessagesFeature(const ViewContext& context)
    : QObject(&context.window), m_messages(context.source.messages()) {
    // Delete is the map's in these windows.
    auto* panel = new MessagesPanel(m_messages, &context.window, MessagesPanel::Keys::Copy);
    panel->setObjectName(QStringLiteral("messagesPane"));
    context.panes.add(QStringLiteral("messages"), tr("Messages"), *panel);
    QAction& opens = context.commands.add({.id = QStringLiteral("messages.open"),
                                           .menu = CommandMenu::View,
                                           .text = tr("Me&ssages"),
                                           .hint = tr("What was told so far, the newest last"),
                                           .keys = QKeySequence(Qt::Key_F4)});
    connect(&opens, &QAction::triggered, this, [&panes = context.panes, panel] {
        panes.open(QStringLiteral("messages"));
        panel->setFocus();
    });
}

void MessagesFeature::add(const QString& text) {
    m_messages.tell(text);
}

}  // namespace leitstand
