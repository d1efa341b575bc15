#include "app/window/panes/map/decisions/loops_feature.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <QAction>
#include <QKeySequence>
#include <QStringList>

#include "app/services/station/station_mapping.h"
#include "app/window/commands/command_table.h"
#include "app/window/panes/map/decisions/robot_title.h"
#include "app/window/source/live_moment.h"
#include "app/window/source/moment_source.h"
#include "core/mission/loops/moved_finds.h"
#include "core/mission/state/decision.h"
#include "widgets/map_decisions/loop_notice.h"
#include "widgets/map_decisions/map_question.h"
#include "widgets/map_view/map_view.h"
#include "widgets/models/numbers.h"
#include "widgets/models/victims/victim_rows.h"

namespace leitstand {
namespace {

constexpr double NoticedOfFinds = 0.05;  ///< [m]

/// Returns "victim 3, hazard 1, victim 2, code 5 and 4 more".
QString namesOf(const std::vector<FindKey>& finds) {
    constexpr std::size_t Named = 4;
    QStringList names;
    for (const auto& [kind, number] : finds) {
        if (static_cast<std::size_t>(names.size()) == Named) break;
        names += kindText(kind) + QLatin1Char(' ') + QString::number(number);
    }
    const QString text = names.join(QStringLiteral(", "));
    if (finds.size() <= Named) return text;
    return LoopsFeature::tr("%1 and %2 more").arg(text).arg(finds.size() - Named);
}

}  // namespace

LoopsFeature::LoopsFeature(const MapContext& context, MapView& view, QObject* parent)
    : QObject(parent), m_context(context), m_view(view) {
    addCommands();
    m_question = new MapQuestion(QStringLiteral("loopQuestion"), {m_close, m_refuse}, m_view);
    m_notice = new LoopNotice(*m_open, m_view, context.mapping.closedLoops().count, this);
    connect(&context.source, &MomentSource::ticked, this, &LoopsFeature::follow);
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
        const auto done = m_context.mapping.undoLoop();
        if (!done) m_context.notify(QString::fromStdString(done.error().text));
    });
}

void LoopsFeature::answer(bool same) {
    if (!m_asked) return;
    const auto done = m_context.mapping.answerLoop(*m_asked, same);
    if (!done) m_context.notify(QString::fromStdString(done.error().text));
}

void LoopsFeature::follow(const LiveMoment& moment) {
    const MissionState& mission = *moment.mission;
    const std::uint64_t newest = mission.decisions->empty() ? 0 : mission.decisions->back().sequence;
    const bool same = newest == m_shown;
    m_shown = newest;
    if (!same) ask(openLoop(mission));
    nameParts();
    showPreview(mission);
    const ClosedLoops loops = m_context.mapping.closedLoops();
    m_notice->follow(loops.count, loops.largest, moment.steady, m_asked.has_value());
    if (same) return;
    m_question->ask(question(mission));
    const bool closed = m_context.mapping.loop().has_value();
    m_open->setEnabled(closed);
    m_context.commands.setHint(
        m_open->objectName(),
        closed ? tr("The newest place where the map met itself comes apart again: scans go back to where "
                    "they were, and it does not close there by itself")
               : tr("No loop closed in the map"));
}

void LoopsFeature::nameParts() {
    const LiveMapPtr map = m_context.mapping.scans();
    if (!map || map == m_named) return;
    m_named = map;
    std::map<std::uint64_t, MapCaption> parts;
    for (const LiveKeyScan& scan : map->scans) {
        if (scan.part == 0 || !scan.counts()) continue;
        MapCaption& part = parts[scan.part];
        part.places.emplace_back(scan.pose.scanInMap.translation());
        if (!part.text.isEmpty()) continue;
        const auto& robots = m_context.source.robots();
        part.text = tr("Map of %1, not joined yet").arg(titleOfRobot(robots, scan.scan->robot));
    }
    std::vector<MapCaption> captions;
    for (auto& [begins, caption] : parts) captions.push_back(std::move(caption));
    m_view.setCaptions(std::move(captions));
}

bool LoopsFeature::areApart(const OpenLoop& loop) const {
    const LiveMapPtr map = m_context.mapping.scans();
    const auto partOf = [&](std::uint64_t id) {
        const auto scan = std::find_if(map->scans.begin(), map->scans.end(),
                                       [id](const LiveKeyScan& one) { return one.id == id; });
        return scan != map->scans.end() ? scan->part : 0;
    };
    return partOf(loop.links.back().from) != partOf(loop.links.back().to);
}

void LoopsFeature::ask(const std::optional<OpenLoop>& loop) {
    if (!loop || !m_asked || m_asked->event != loop->event) {
        m_preview.reset();
        m_view.setGhosts({});
    }
    m_asked = loop;
    if (m_asked) m_asked->parts = m_asked->parts && areApart(*m_asked);
    const bool open = loop.has_value();
    for (QAction* one : {m_close, m_refuse}) one->setEnabled(open);
    const QString none = tr("Nothing is asked about the map");
    m_context.commands.setHint(
        m_close->objectName(),
        open ? tr("The scans that see it are put together, and all others follow") : none);
    m_context.commands.setHint(
        m_refuse->objectName(),
        open ? tr("The map stays as it is, and is not asked about there again") : none);
    m_view.setSeam(open ? std::optional(Measurement{loop->at, loop->would}) : std::nullopt);
}

void LoopsFeature::showPreview(const MissionState& mission) {
    if (!m_asked) return;
    const LoopPreviewPtr newest = m_context.mapping.preview(*m_asked);
    if (!newest || newest == m_preview) return;
    m_preview = newest;
    m_view.setGhosts(m_preview->moved);
    m_question->ask(question(mission));
}

QString LoopsFeature::question(const MissionState& mission) const {
    if (!m_asked) return {};
    const auto metres = [](double length) { return numberText(length, 2) + QStringLiteral(" m"); };
    QString text =
        m_asked->parts
            ? tr("Did these two parts of the map see the same place?")
            : tr("Is this a place that was seen before? The map is %1 off here, more than expected.")
                  .arg(metres(m_asked->seam()));
    if (!m_preview) return text;
    text += QLatin1Char('\n');
    text += m_preview->moved.empty() ? tr("If it is, no scan moves.")
                                     : tr("Violet: the map if it is. Scans moved: %1, by up to %2.")
                                           .arg(m_preview->moved.size())
                                           .arg(metres(m_preview->largest));
    const auto finds = findsMovedBy(mission, m_preview->moved, NoticedOfFinds);
    if (!finds.empty()) text += QLatin1Char(' ') + tr("Finds moved: %1.").arg(namesOf(finds));
    if (m_preview->parted > 0)
        text +=
            QLatin1Char(' ') + tr("Links of other loops that speak against it: %1.").arg(m_preview->parted);
    return text;
}

}  // namespace leitstand
