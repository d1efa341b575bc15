#include "app/window/panes/alarms/logged_alarms.h"

#include <QMainWindow>

#include "app/window/input/selection.h"
#include "app/window/source/review_bridge.h"
#include "widgets/alarms/alarm_panel.h"
#include "widgets/models/live/texts/alarm_text.h"

namespace leitstand {

LoggedAlarms::LoggedAlarms(const ReviewContext& context)
    : QObject(&context.window), m_context(context), m_panel(new AlarmPanel(&context.window)) {
    m_panel->setReadOnly(true);
    connect(&context.source, &MomentSource::ticked, this, &LoggedAlarms::show);
}

QWidget& LoggedAlarms::pane() const {
    return *m_panel;
}

void LoggedAlarms::show(const LiveMoment& moment) {
    m_panel->show(alarmLinesOf(m_context.review.reviewed()->alarms, m_context.selection.faces(), moment.now),
                  {});
}

}  // namespace leitstand
