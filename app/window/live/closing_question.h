#pragma once

#include <chrono>
#include <set>
#include <string>
#include <vector>

#include <QObject>
#include <QPointer>
#include <QString>

#include "app/window/panes/view_context.h"
#include "app/window/source/live_moment.h"
#include "core/robot/robot_description.h"

class QMessageBox;

namespace leitstand {

/// When the window is closed, asks what to do with robots that drive by themselves, since they would continue
/// without a station. Robots that the operator drives stop in any case, without a question. The question is
/// not modal: STOP, keys and gamepads still work.
class ClosingQuestion final : public QObject {
    Q_OBJECT
public:
    explicit ClosingQuestion(const LiveContext& context);

    /// Returns whether the window may close now. If not, asks the operator, whose answer may close the
    /// window.
    [[nodiscard]] bool mayClose();
    void allow() { m_allowed = true; }  ///< asks no questions from now on

private:
    [[nodiscard]] std::vector<const RobotDescription*> drivingThemselves() const;
    void ask(const QString& why = {});
    void stopThem();
    void follow(const LiveMoment& moment);
    void close();

    LiveContext m_context;
    QPointer<QMessageBox> m_question;
    bool m_allowed = false;
    std::set<std::string> m_stopping;               ///< robots that must stand before the window closes
    std::chrono::steady_clock::time_point m_since;  ///< when their stop was sent
};

}  // namespace leitstand
