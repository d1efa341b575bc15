#include "app/window/panes/link/link_feature.h"

#include <utility>
#include <vector>

#include <QAction>
#include <QLabel>
#include <QMainWindow>

#include "app/services/mapping/station_scanners.h"
#include "app/services/station/station.h"
#include "app/services/station/station_mapping.h"
#include "app/services/station/station_streams.h"
#include "app/window/commands/command_table.h"
#include "app/window/frame/corner_badge.h"
#include "app/window/input/selection.h"
#include "app/window/source/moment_source.h"
#include "widgets/link/link_pane.h"
#include "widgets/models/live/robots/stream_rows.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds Rhythm(500);  ///< figures that change faster cannot be read

}  // namespace

LinkFeature::LinkFeature(const LiveContext& context)
    : QObject(&context.window),
      m_context(context),
      m_thin(&context.commands.add({.id = QStringLiteral("link.thin"),
                                    .menu = CommandMenu::Robot,
                                    .text = tr("&Thin link"),
                                    .hint = tr("Asks robots for less, so that what matters comes: commands "
                                               "and stop, telemetry, scans, one camera, the rest"),
                                    .keys = QKeySequence(Qt::Key_T),
                                    .checkable = true})),
      m_pane(new LinkPane(*m_thin, &context.window)),
      m_badge(makeCornerBadge(context.window, QStringLiteral("thinBadge"))) {
    m_badge->setText(tr("THIN LINK (T)"));
    m_badge->setToolTip(tr("Robots are asked for less: other cameras come rarely or not at all"));
    StationStreams& streams = context.station.streams();
    connect(m_thin, &QAction::toggled, this, &LinkFeature::setThin);
    connect(m_pane, &LinkPane::requested, this,
            [this, &streams](const QString& robot, const QString& topic, const StreamRequest& request) {
                const auto done = streams.request(robot.toStdString(), topic.toStdString(), request);
                if (!done) m_context.notify(QString::fromStdString(done.error().text));
            });
    connect(m_pane, &LinkPane::mapChosen, this, [this](const QString& robot, const QString& topic) {
        const auto done =
            m_context.station.mapping().scanners().mapWith(robot.toStdString(), topic.toStdString());
        if (!done) m_context.notify(QString::fromStdString(done.error().text));
    });
    connect(m_pane, &LinkPane::budgetChosen, this, [&streams](double megabits) {
        ThinSettings settings = streams.thinSettings();
        settings.budget = megabits;
        streams.setThin(settings);
    });
    const auto select = [this, &streams] { streams.select(m_context.selection.name().toStdString()); };
    connect(&context.selection, &Selection::changed, this, select);
    select();
    connect(&context.source, &MomentSource::ticked, this, &LinkFeature::show);
}

QWidget& LinkFeature::pane() const {
    return *m_pane;
}

void LinkFeature::setThin(bool on) {
    m_context.station.streams().thin({}, on);
    m_badge->setVisible(on);
    m_context.notify(on ? tr("Thin link: telemetry, scans and one camera come first (T ends it)")
                        : tr("The link is not thin any more: everything as robots like"));
}

void LinkFeature::show(const LiveMoment& moment) {
    const StationStreams& streams = m_context.station.streams();
    if (!m_pane->isVisible() || moment.steady - m_shown < Rhythm) return;
    m_shown = moment.steady;
    std::vector<StreamRow> rows;
    double megabits = 0.0;
    for (const RobotDescription& robot : m_context.selection.robots()) {
        const LinkStatus& link = moment.view(robot.name).link;
        megabits += link.megabitsPerSecond;
        const auto settings = [&](const std::string& topic) {
            return StreamSetting{streams.own(robot.name, topic), streams.effective(robot.name, topic)};
        };
        appendStreamRows(rows, m_context.selection.faceOfRobot(robot), robot, link,
                         m_context.station.mapping().scanners().mapsWith(robot.name), settings);
    }
    m_pane->show(std::move(rows), megabits, streams.isThin({}), streams.thinSettings().budget);
}

}  // namespace leitstand
