#pragma once

#include <map>
#include <string>
#include <vector>

#include <QObject>
#include <QString>

#include "core/base/pose.h"

class QAction;
class QWidget;

namespace leitstand {

class CommandTable;
class MapQuestion;
class MovedPlaces;

/// Asks over the map whether a robot shall still go to its goal, after the map moved there. The goal was
/// withdrawn while the robot was on its way or about to go.
class GoalQuestion final : public QObject {
    Q_OBJECT
public:
    GoalQuestion(CommandTable& commands, QWidget& map, QObject* parent);

    /// Asks about @p robot, shown as @p title, whose goal @p wasInMap is withdrawn. The same place is at
    /// @p goalInMap now.
    void ask(const std::string& robot, const QString& title, const Pose& wasInMap, const Pose& goalInMap);
    /// Ends the question about @p robot: it was sent elsewhere, or stopped.
    void forget(const std::string& robot);
    /// Moves the goals in question along with the map.
    void follow(const MovedPlaces& places);
    [[nodiscard]] std::vector<std::string> robots() const;  ///< those with an open question

signals:
    void confirmed(const std::string& robot, const leitstand::Pose& goalInMap);

private:
    struct Withdrawn {
        QString title;
        Pose wasInMap, goalInMap;
    };
    void answer(bool again);
    void show();  ///< shows the question of the first robot, or hides it without any

    CommandTable& m_commands;
    QAction *m_again, *m_leave;
    MapQuestion* m_question;
    std::map<std::string, Withdrawn> m_asked;
};

}  // namespace leitstand
