#pragma once

#include <map>
#include <string>

#include <QObject>
#include <QString>

#include "core/base/pose.h"

class QAction;
class QWidget;

namespace leitstand {

class CommandTable;
class MapQuestion;

/// Asks over the map whether a robot is to go on to a place that moved with the map while it was on its way,
/// or about to go.
class GoalQuestion final : public QObject {
    Q_OBJECT
public:
    GoalQuestion(CommandTable& commands, QWidget& map, QObject* parent);

    /// The goal of @p robot, known as @p title, is withdrawn; the same place lies at @p goalInMap now, @p
    /// shift aside [m].
    void ask(const std::string& robot, const QString& title, const Pose& goalInMap, double shift);
    /// Whatever was asked of @p robot is over: it was sent elsewhere.
    void forget(const std::string& robot);

signals:
    void confirmed(const std::string& robot, const leitstand::Pose& goalInMap);

private:
    struct Withdrawn {
        QString title;
        Pose goalInMap;
        double shift = 0.0;  ///< [m]
    };
    void answer(bool again);
    void show();  ///< of several robots the first one's

    CommandTable& m_commands;
    QAction *m_again, *m_leave;
    MapQuestion* m_question;
    std::map<std::string, Withdrawn> m_asked;
};

}  // namespace leitstand
