#include "app/window/live/map/loops_feature.h"

#include <QAction>
#include <QKeySequence>

#include "app/services/station/station.h"
#include "app/services/station/station_mapping.h"
#include "app/window/commands/command_table.h"
#include "app/window/live/live_bridge.h"
#include "app/window/live/live_moment.h"
#include "core/mission/loops/open_loops.h"
#include "widgets/map_decisions/loop_question.h"
#include "widgets/map_view/map_view.h"
#include "widgets/models/numbers.h"

namespace leitstand {

LoopsFeature::LoopsFeature(const LiveContext& context, MapView& view, QObject* parent)
    : QObject(parent), m_context(context), m_view(view) {
    addCommands();
    m_question = new LoopQuestion(*m_close, *m_refuse, m_view);
    connect(&context.bridge, &LiveBridge::ticked, this,
            [this](const LiveMoment& moment) { follow(*moment.mission); });
}

void LoopsFeature::addCommands() {
    m_context.commands.separate(CommandMenu::Map);
    const auto add = [this](const QString& id, const QString& text, const QKeySequence& keys) {
        QAction& action = m_context.commands.add(
            {.id = id, .menu = CommandMenu::Map, .text = text, .hint = {}, .keys = keys});
        action.setEnabled(false);
        return &action;
    };
    m_close = add(QStringLiteral("loop.close"), tr("It is the same place: c&lose the loop"),
                  QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_C));
    m_refuse = add(QStringLiteral("loop.refuse"), tr("It is &another place"),
                   QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_N));
    m_open = add(QStringLiteral("loop.undo"), tr("Take back the cl&osed loop"),
                 QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_Z));
    m_close->setIconText(tr("Same place"));
    m_refuse->setIconText(tr("Another place"));
    m_open->setIconText(tr("Open loop"));
    connect(m_close, &QAction::triggered, this, [this] { answer(true); });
    connect(m_refuse, &QAction::triggered, this, [this] { answer(false); });
    connect(m_open, &QAction::triggered, this, [this] {
        const auto done = m_context.bridge.station().mapping().undoLoop();
        if (!done) emit told(QString::fromStdString(done.error().text));
    });
}

void LoopsFeature::answer(bool same) {
    const auto done = m_context.bridge.station().mapping().answerLoop(same);
    if (!done) emit told(QString::fromStdString(done.error().text));
}

void LoopsFeature::follow(const MissionState& mission) {
    const std::uint64_t newest = mission.decisions->empty() ? 0 : mission.decisions->back().sequence;
    if (newest == m_shown) return;
    m_shown = newest;
    CommandTable& commands = m_context.commands;
    const auto open = openLoop(mission);
    for (QAction* one : {m_close, m_refuse}) one->setEnabled(open.has_value());
    const QString none = tr("Nothing is asked about the map");
    commands.setHint(m_close->objectName(),
                     open ? tr("The scans that see it are put together, and all others follow") : none);
    commands.setHint(m_refuse->objectName(),
                     open ? tr("The map stays as it is, and is not asked about there again") : none);
    m_question->ask(
        open ? tr("Is this a place that was seen before? The map is %1 off here, more than expected.")
                   .arg(numberText(open->seam(), 2) + QStringLiteral(" m"))
             : QString());
    m_view.setSeam(open ? std::optional(Measurement{open->at, open->would}) : std::nullopt);
    const bool closed = m_context.bridge.station().mapping().loop().has_value();
    m_open->setEnabled(closed);
    commands.setHint(m_open->objectName(),
                     closed
                         ? tr("The newest place where the map met itself comes apart again: scans go back to "
                              "where they were, and it does not close there by itself")
                         : tr("No loop closed in the map"));
}

}  // namespace leitstand
