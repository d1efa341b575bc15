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

/// Asks whether a robot shall still drive to its goal after the map moved there. The goal was withdrawn while
/// the robot was driving or about to drive. The question is shown over the map.
class GoalQuestion final : public QObject {
    Q_OBJECT
public:
    GoalQuestion(CommandTable& commands, QWidget& map, QObject* parent);

    /// Asks about @p robot, called @p title, whose goal @p wasInMap was withdrawn. The same place is now at
    /// @p goalInMap.
    void ask(const std::string& robot, const QString& title, const Pose& wasInMap, const Pose& goalInMap);
    /// Ends the question about @p robot, because it was sent elsewhere or stopped.
    void forget(const std::string& robot);
    /// Moves the goals in question together with the map.
    void follow(const MovedPlaces& places);
    [[nodiscard]] std::vector<std::string> robots() const;  ///< robots with an open question

signals:
    void confirmed(const std::string& robot, const leitstand::Pose& goalInMap);

private:
    struct Withdrawn {
        QString title;
        Pose wasInMap, goalInMap;
    };
    void answer(bool again);
    void show();  ///< shows the question about the first robot; hides it if there is none

    CommandTable& m_commands;
    QAction *m_again, *m_leave;
    MapQuestion* m_question;
    std::map<std::string, Withdrawn> m_asked;
};

}  // namespace leitstand
