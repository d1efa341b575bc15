#pragma once

#include <QObject>

#include "app/window/panes/view_context.h"

class QWidget;

namespace leitstand {

class AlarmPanel;
struct LiveMoment;

/// Shows the alarms that were active at the moment that a review shows. They cannot be acknowledged.
class LoggedAlarms final : public QObject {
    Q_OBJECT
public:
    explicit LoggedAlarms(const ReviewContext& context);

    [[nodiscard]] QWidget& pane() const;

private:
    void show(const LiveMoment& moment);

    ReviewContext m_context;
    AlarmPanel* m_panel;
};

}  // namespace leitstand
