#include "app/window/panes/frames/frames_feature.h"

#include <chrono>
#include <vector>

#include <QAction>
#include <QMainWindow>

#include "app/services/station/frame_watch.h"
#include "app/services/station/station.h"
#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/input/selection.h"
#include "app/window/source/moment_source.h"
#include "widgets/frames/frames_panel.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds ShowEvery(500);

}  // namespace

FramesFeature::FramesFeature(const LiveContext& context)
    : QObject(&context.window), m_context(context), m_panel(new FramesPanel(&context.window)) {
    m_panel->setObjectName(QStringLiteral("framesPane"));
    QAction& open = m_context.commands.add(
        {.id = QStringLiteral("frames.open"),
         .menu = CommandMenu::Robot,
         .text = tr("&Frames of the robot (tf)"),
         .hint = tr("The tree of its frames, where each lies in its parent, how often and when that came")});
    connect(&open, &QAction::triggered, this, [this] { m_context.panes.open(QStringLiteral("frames")); });
    connect(&context.selection, &Selection::changed, this, &FramesFeature::show);
    connect(&m_shows, &QTimer::timeout, this, [this] {
        if (m_panel->isVisible()) show();
    });
    m_shows.start(ShowEvery);
    show();
}

QWidget& FramesFeature::pane() const {
    return *m_panel;
}

void FramesFeature::show() {
    const RobotDescription* const robot = m_context.selection.robot();
    if (robot == nullptr) return m_panel->showFrames({}, {}, false);
    const FrameWatch& frames = m_context.station.frames();
    const std::vector<FrameRow> rows = frames.rows(robot->name);
    bool attention = false;
    const QString summary = framesSummary(rows, frames.unconnected(*robot), attention);
    m_panel->showFrames(frameLines(rows, m_context.source.moment().now), summary, attention);
}

}  // namespace leitstand
