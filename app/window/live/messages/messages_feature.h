#pragma once

#include <QObject>
#include <QString>

#include "app/window/live/live_context.h"

namespace leitstand {

class MessageListModel;

/// Pane Messages (F4): what the operator was told since the program began, each with its time.
class MessagesFeature final : public QObject {
    Q_OBJECT
public:
    explicit MessagesFeature(const ViewContext& context);

    void add(const QString& text);

private:
    MessageListModel& m_messages;
};

}  // namespace leitstand
