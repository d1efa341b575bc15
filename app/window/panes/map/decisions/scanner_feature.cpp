#include "app/window/panes/map/decisions/scanner_feature.h"

#include <QAction>

#include "app/services/mapping/station_scanners.h"
#include "app/services/station/station.h"
#include "app/services/station/station_mapping.h"
#include "app/window/commands/command_table.h"
#include "app/window/panes/map/decisions/robot_title.h"
#include "app/window/source/live_moment.h"
#include "app/window/source/moment_source.h"
#include "core/mission/loops/open_loops.h"
#include "widgets/map_decisions/map_question.h"
#include "widgets/map_view/map_view.h"
#include "widgets/models/map/scanner_text.h"

namespace leitstand {

ScannerFeature::ScannerFeature(const LiveContext& context, MapView& view, QObject* parent)
    : QObject(parent), m_context(context) {
    const auto add = [this](const QString& id, const QString& text) {
        QAction& action = m_context.commands.add(
            {.id = id, .menu = CommandMenu::Map, .text = text, .hint = {}, .keys = {}});
        action.setEnabled(false);
        return &action;
    };
    m_use = add(QStringLiteral("scanner.use"), tr("Co&rrect the scanner as the map says"));
    m_leave = add(QStringLiteral("scanner.leave"), tr("Leave the sca&nner as it is"));
    m_use->setIconText(tr("Correct"));
    m_leave->setIconText(tr("Leave"));
    m_question = new MapQuestion(QStringLiteral("scannerQuestion"), {m_use, m_leave}, view);
    connect(m_use, &QAction::triggered, this, [this] { answer(true); });
    connect(m_leave, &QAction::triggered, this, [this] { answer(false); });
    connect(&context.source, &MomentSource::ticked, this, &ScannerFeature::follow);
    const QString none = tr("The map finds no scanner to be off");
    for (QAction* one : {m_use, m_leave}) m_context.commands.setHint(one->objectName(), none);
}

void ScannerFeature::answer(bool correct) {
    if (!m_asked) return;
    const auto done = m_context.station.mapping().scanners().answer(*m_asked, correct);
    if (!done) m_context.notify(QString::fromStdString(done.error().text));
}

void ScannerFeature::follow(const LiveMoment& moment) {
    auto asked = m_context.station.mapping().scanners().question();
    if (openLoop(*moment.mission)) asked.reset();  // one question at a time
    if (asked == m_asked) return;
    m_asked = std::move(asked);
    const bool open = m_asked.has_value();
    for (QAction* one : {m_use, m_leave}) one->setEnabled(open);
    const QString none = tr("The map finds no scanner to be off");
    m_context.commands.setHint(m_use->objectName(),
                               open ? tr("From its next scan on, and in the robot's file: also when it is "
                                         "connected next time. What is in the map stays")
                                    : none);
    m_context.commands.setHint(m_leave->objectName(),
                               open ? tr("Nothing changes, and it is not asked about again") : none);
    m_question->ask(question());
}

QString ScannerFeature::question() const {
    if (!m_asked) return {};
    return scannerQuestionText(titleOfRobot(m_context.station.robots(), m_asked->robot), m_asked->more);
}

}  // namespace leitstand
