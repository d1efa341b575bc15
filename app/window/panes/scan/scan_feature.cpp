#include "app/window/panes/scan/scan_feature.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include <QAction>
#include <QMainWindow>

#include "app/window/commands/command_table.h"
#include "app/window/input/selection.h"
#include "app/window/source/moment_source.h"
#include "core/base/time.h"
#include "core/event/stream_role.h"
#include "core/mission/state/scan_state.h"
#include "core/robot/streams/stream_table.h"
#include "widgets/virtual_scan/virtual_scan_pane.h"

namespace leitstand {
namespace {

/// Returns the age of the newest scan of @p reported [s]. Infinite when none came.
double scanAge(const RobotState& reported, Time now) {
    double age = std::numeric_limits<double>::infinity();
    for (const auto& [topic, stream] : reported.streams) {
        if (!stream.role || !isScanner(*stream.role)) continue;
        age = std::min(age, toSeconds(now - stream.received));
    }
    return age;
}

}  // namespace

ScanFeature::ScanFeature(const ViewContext& context)
    : QObject(&context.window), m_context(context), m_pane(new VirtualScanPane(&context.window)) {
    const auto setRobot = [this] {
        if (const RobotDescription* robot = m_context.selection.robot())
            m_pane->setRobot(m_context.selection.face(), robot->footprint);
    };
    connect(&context.selection, &Selection::changed, this, setRobot);
    setRobot();
    QAction& laser =
        context.commands.add({.id = "scan.laser",
                              .menu = CommandMenu::View,
                              .text = tr("&Laser in the virtual scan"),
                              .hint = tr("Draws what plane lasers measured, as it came, over the "
                                         "contours of walls and obstacles"),
                              .checkable = true});
    laser.setChecked(true);
    connect(&laser, &QAction::toggled, m_pane, &VirtualScanPane::setLaserShown);
    connect(&context.source, &MomentSource::ticked, this, &ScanFeature::show);
    connect(m_pane, &VirtualScanPane::pointedAt, this, &ScanFeature::pointed);
    connect(m_pane, &VirtualScanPane::pointingEnded, this, &ScanFeature::pointingEnded);
}

QWidget& ScanFeature::pane() const {
    return *m_pane;
}

void ScanFeature::setPointing(bool pointing) {
    m_pane->setPointing(pointing);
}

void ScanFeature::show(const LiveMoment& moment) {
    const std::string name = m_context.selection.name().toStdString();
    const RobotView& view = moment.view(name);
    double age = scanAge(moment.reported(name), moment.now);
    const MomentSource::ScanSource source = m_context.source.scanSource(name);
    if (source.keyScans)
        age = view.around ? view.around->youngest() : std::numeric_limits<double>::infinity();
    m_pane->setLimits(source.limits);
    m_pane->show(view.around, view.drive.velocity, age);
}

}  // namespace leitstand
