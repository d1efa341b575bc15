#pragma once

#include <QObject>

#include "app/window/panes/view_context.h"

namespace leitstand {

class MessagesPanel;

/// The pane of messages to the operator (F4): all since the station or review was opened, with their times.
class MessagesFeature final : public QObject {
    Q_OBJECT
public:
    explicit MessagesFeature(const ViewContext& context);

    [[nodiscard]] MessagesPanel& pane() const { return *m_panel; }

private:
    MessagesPanel* m_panel;
};

}  // namespace leitstand
