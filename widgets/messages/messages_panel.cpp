#include "widgets/messages/messages_panel.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QListView>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/models/message_list_model.h"
#include "widgets/tables/tone_delegate.h"

namespace leitstand {
namespace {

QToolButton* quietButton(QAction* action, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setDefaultAction(action);
    button->setProperty("quiet", true);
    return button;
}

}  // namespace

MessagesPanel::MessagesPanel(MessageListModel& messages, QWidget* parent, Keys keys)
    : QWidget(parent), m_messages(messages), m_list(new QListView(this)) {
    m_list->setObjectName(QStringLiteral("messages"));
    m_list->setAccessibleName(tr("Messages"));
    m_list->setModel(&messages);
    m_list->setItemDelegate(new ToneDelegate(m_list));
    m_list->setWordWrap(true);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setContextMenuPolicy(Qt::ActionsContextMenu);
    setFocusProxy(m_list);

    auto* dismiss = new QAction(tr("Dismiss"), this);
    if (keys == Keys::CopyAndDelete) {
        dismiss->setShortcut(Qt::Key_Delete);
        dismiss->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        dismiss->setToolTip(tr("Takes the chosen message away (Del)"));
    } else {
        dismiss->setToolTip(tr("Takes the chosen message away"));
    }
    connect(dismiss, &QAction::triggered, this, [this] { m_messages.dismiss(m_list->currentIndex().row()); });
    auto* dismissAll = new QAction(tr("Dismiss all"), this);
    connect(dismissAll, &QAction::triggered, this, [this] { m_messages.clear(); });
    auto* copy = new QAction(tr("Copy"), this);
    copy->setShortcut(QKeySequence::Copy);
    copy->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(copy, &QAction::triggered, this, [this] {
        QApplication::clipboard()->setText(m_list->currentIndex().data(Qt::ToolTipRole).toString());
    });
    addActions({dismiss, copy});
    m_list->addActions({copy, dismiss, dismissAll});
    connect(&messages, &QAbstractItemModel::rowsInserted, m_list, &QListView::scrollToBottom);

    auto* buttons = new QVBoxLayout;
    buttons->addWidget(quietButton(dismiss, this));
    buttons->addWidget(quietButton(dismissAll, this));
    buttons->addStretch();
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(m_list, 1);
    layout->addLayout(buttons);
}

}  // namespace leitstand
