#include "app/window/panes/map/goal_question.h"

#include <utility>

#include <QAction>

#include "app/window/commands/command_table.h"
#include "core/mapping/live/map/moved_places.h"
#include "widgets/map_decisions/map_question.h"
#include "widgets/models/numbers.h"

namespace leitstand {

GoalQuestion::GoalQuestion(CommandTable& commands, QWidget& map, QObject* parent)
    : QObject(parent),
      m_commands(commands),
      m_again(&commands.add({.id = QStringLiteral("goal.again"),
                             .menu = CommandMenu::Robot,
                             .text = tr("Send it to where its goal lies &now")})),
      m_leave(&commands.add({.id = QStringLiteral("goal.leave"),
                             .menu = CommandMenu::Robot,
                             .text = tr("Leave its goal &withdrawn")})) {
    m_again->setIconText(tr("Send again"));
    m_leave->setIconText(tr("Leave it"));
    m_question = new MapQuestion(QStringLiteral("goalQuestion"), {m_again, m_leave}, map);
    connect(m_again, &QAction::triggered, this, [this] { answer(true); });
    connect(m_leave, &QAction::triggered, this, [this] { answer(false); });
    show();
}

void GoalQuestion::ask(const std::string& robot, const QString& title, const Pose& wasInMap,
                       const Pose& goalInMap) {
    m_asked[robot] = {title, wasInMap, goalInMap};
    show();
}

void GoalQuestion::follow(const MovedPlaces& places) {
    if (m_asked.empty()) return;
    for (auto& [robot, asked] : m_asked)
        asked.goalInMap = places.at(asked.goalInMap.translation()) * asked.goalInMap;
    show();
}

std::vector<std::string> GoalQuestion::robots() const {
    std::vector<std::string> all;
    for (const auto& [robot, asked] : m_asked) all.push_back(robot);
    return all;
}

void GoalQuestion::forget(const std::string& robot) {
    if (m_asked.erase(robot) > 0) show();
}

void GoalQuestion::answer(bool again) {
    if (m_asked.empty()) return;
    const auto [robot, withdrawn] = *m_asked.begin();
    // The question stays open in case sending is refused.
    if (again) return emit confirmed(robot, withdrawn.goalInMap);
    forget(robot);
}

void GoalQuestion::show() {
    const bool open = !m_asked.empty();
    for (QAction* const one : {m_again, m_leave}) {
        one->setEnabled(open);
        m_commands.setHint(one->objectName(), open ? QString() : tr("No goal was withdrawn"));
    }
    if (!open) return m_question->ask({});
    const Withdrawn& first = m_asked.begin()->second;
    m_question->ask(tr("%1: the map moved by %2 m under its goal, which is withdrawn. Send it to where that "
                       "place lies now?")
                        .arg(first.title, numberText(distanceBetween(first.wasInMap, first.goalInMap), 2)));
}

}  // namespace leitstand
