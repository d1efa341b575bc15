#pragma once

#include <QWidget>

class QListView;

namespace leitstand {

class MessageListModel;

/// A list of messages to the operator. Rows can be dismissed one by one or all at once.
class MessagesPanel final : public QWidget {
    Q_OBJECT
public:
    /// The keys that it handles while it has the focus.
    enum class Keys { CopyAndDelete, Copy };

    /// Shows @p messages, which must outlive this panel.
    explicit MessagesPanel(MessageListModel& messages, QWidget* parent = nullptr,
                           Keys keys = Keys::CopyAndDelete);

private:
    MessageListModel& m_messages;
    QListView* m_list;
};

}  // namespace leitstand
