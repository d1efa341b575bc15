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

/// What becomes of robots that drive themselves when the window is closed: they go on without a station, so
/// the operator is asked. Robots that are driven stand in any case, and are no question. Nothing waits for
/// the answer: STOP, keys and gamepads work on.
class ClosingQuestion final : public QObject {
    Q_OBJECT
public:
    explicit ClosingQuestion(const LiveContext& context);

    /// Whether the window may close now; else the operator is asked, and the window is closed by the answer.
    [[nodiscard]] bool mayClose();
    void allow() { m_allowed = true; }  ///< nobody is asked any more

private:
    [[nodiscard]] std::vector<const RobotDescription*> drivingThemselves() const;
    void ask(const QString& why = {});
    void stopThem();
    void follow(const LiveMoment& moment);
    void close();

    LiveContext m_context;
    QPointer<QMessageBox> m_question;
    bool m_allowed = false;
    std::set<std::string> m_stopping;               ///< robots whose standing is waited for
    std::chrono::steady_clock::time_point m_since;  ///< when their stop was sent
};

}  // namespace leitstand
