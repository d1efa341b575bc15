#include "app/window/panes/drive/strip_feature.h"

#include <QMainWindow>

#include "app/services/station/safety/station_alarms.h"
#include "app/services/station/station.h"
#include "app/window/input/selection.h"
#include "app/window/source/moment_source.h"
#include "widgets/drive/drive_strip.h"
#include "widgets/models/live/robots/drive_state.h"

namespace leitstand {

StripFeature::StripFeature(const ViewContext& context)
    : QObject(&context.window), m_context(context), m_strip(new DriveStrip(&context.window)) {
    connect(&context.source, &MomentSource::ticked, this, &StripFeature::show);
}

void StripFeature::show(const LiveMoment& moment) {
    const RobotDescription* const robot = m_context.selection.robot();
    if (robot == nullptr) return;
    const bool live = m_context.liveStation != nullptr;
    const AlarmLimits limits = live ? m_context.liveStation->alarms().limits() : AlarmLimits{};
    DriveState state =
        driveStateOf(m_context.selection.face(), *robot, moment.view(robot->name),
                     moment.reported(robot->name), m_context.source.gas(robot->name), moment.now, limits);
    if (!live) state.grant.choice = GrantFigures::Choice::None;
    m_strip->show(state);
}

}  // namespace leitstand
