#include "app/window/review/review_clock.h"

#include <optional>

#include <QMainWindow>

#include "app/window/panes/view_context.h"
#include "app/window/source/moment_source.h"
#include "core/mission/state/mission_clock.h"
#include "widgets/mission/clock_face.h"
#include "widgets/models/live/texts/clock_text.h"

namespace leitstand {

ReviewClock::ReviewClock(const ViewContext& context)
    : QObject(&context.window), m_face(new ClockFace(&context.window)) {
    connect(&context.source, &MomentSource::ticked, this, &ReviewClock::show);
}

QWidget& ReviewClock::bar() const {
    return *m_face;
}

void ReviewClock::show(const LiveMoment& moment) {
    m_face->show(clockText(clockAt(
        moment.mission->clock ? std::optional(moment.mission->clock->sample) : std::nullopt, moment.now)));
}

}  // namespace leitstand
