#include "app/window/panes/readings/readings_feature.h"

#include <chrono>
#include <vector>

#include <QAction>
#include <QMainWindow>

#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/input/selection.h"
#include "app/window/source/moment_source.h"
#include "widgets/readings/readings_panel.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds ShowEvery(200);  // numbers that change faster are not read

}  // namespace

ReadingsFeature::ReadingsFeature(const ViewContext& context)
    : QObject(&context.window), m_context(context), m_panel(new ReadingsPanel(&context.window)) {
    m_panel->setObjectName(QStringLiteral("readingsPane"));
    QAction& open = m_context.commands.add({.id = QStringLiteral("readings.open"),
                                            .menu = CommandMenu::Robot,
                                            .text = tr("&Readings of its sensors"),
                                            .hint = tr("Temperatures, distances and all other numbers that "
                                                       "the robot's file names, with their limits"),
                                            .keys = QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_R)});
    connect(&open, &QAction::triggered, this, [this] { m_context.panes.open(QStringLiteral("readings")); });
    connect(m_panel, &ReadingsPanel::readingChosen, this, &ReadingsFeature::plot);
    connect(&context.selection, &Selection::changed, this, &ReadingsFeature::show);
    connect(&m_shows, &QTimer::timeout, this, [this] {
        if (m_panel->isVisible()) show();
    });
    m_shows.start(ShowEvery);
    show();
}

QWidget& ReadingsFeature::pane() const {
    return *m_panel;
}

void ReadingsFeature::show() {
    const RobotDescription* const robot = m_context.selection.robot();
    const LiveMoment& moment = m_context.source.moment();
    m_panel->showReadings(robot == nullptr ? std::vector<ReadingRow>()
                                           : readingRows(*robot, moment.reported(robot->name), moment.now));
    plot();
}

void ReadingsFeature::plot() {
    const RobotDescription* const robot = m_context.selection.robot();
    const auto row = m_panel->chosen();
    if (robot == nullptr || !row) return m_panel->showPlot({}, ValueTrend::Span);
    const ValueTrend trend = m_context.source.reading(robot->name, row->topic, row->index);
    m_panel->showPlot(trend.samples(m_context.source.moment().now), ValueTrend::Span);
}

}  // namespace leitstand
