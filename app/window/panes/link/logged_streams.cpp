#include "app/window/panes/link/logged_streams.h"

#include <utility>
#include <vector>

#include <QMainWindow>

#include "app/window/input/selection.h"
#include "app/window/source/moment_source.h"
#include "widgets/link/stream_list.h"
#include "widgets/models/live/robots/stream_rows.h"

namespace leitstand {

LoggedStreams::LoggedStreams(const ReviewContext& context)
    : QObject(&context.window),
      m_context(context),
      m_streams(new StreamList(StreamTable::Of::Log, &context.window)) {
    connect(&context.source, &MomentSource::ticked, this, &LoggedStreams::show);
}

QWidget& LoggedStreams::pane() const {
    return *m_streams;
}

void LoggedStreams::show(const LiveMoment& moment) {
    if (!m_streams->isVisible()) return;
    std::vector<StreamRow> rows;
    for (const RobotDescription& robot : m_context.selection.robots()) {
        const StreamDescription* const maps = robot.mappingStream();
        appendStreamRows(rows, m_context.selection.faceOfRobot(robot), robot, moment.view(robot.name).link,
                         maps != nullptr ? maps->topic : std::string(),
                         [](const std::string&) { return StreamSetting(); });
    }
    m_streams->setRows(std::move(rows));
}

}  // namespace leitstand
