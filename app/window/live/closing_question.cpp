#include "app/window/live/closing_question.h"

#include <QGuiApplication>
#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>
#include <QSessionManager>

#include "app/services/station/station.h"
#include "app/window/input/selection.h"
#include "app/window/source/moment_source.h"
#include "widgets/models/live/texts/mode_label.h"
#include "widgets/models/live/texts/stop_line.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds StopPatience(4);  ///< time for robots to come to a stand

}  // namespace

ClosingQuestion::ClosingQuestion(const LiveContext& context) : QObject(&context.window), m_context(context) {
    connect(&context.source, &MomentSource::ticked, this, &ClosingQuestion::follow);
    // The session ends whatever windows answer. Should it go on after all, this window closes without a
    // question.
    connect(qGuiApp, &QGuiApplication::commitDataRequest, this, &ClosingQuestion::allow);
}

std::vector<const RobotDescription*> ClosingQuestion::drivingThemselves() const {
    std::vector<const RobotDescription*> found;
    const LiveMoment& moment = m_context.source.moment();
    for (const RobotDescription& robot : m_context.selection.robots()) {
        if (!moment.mission) continue;
        if (drivesItself(moment.view(robot.name), moment.reported(robot.name).mode)) found.push_back(&robot);
    }
    return found;
}

bool ClosingQuestion::mayClose() {
    if (m_allowed || drivingThemselves().empty()) return true;
    if (m_stopping.empty() && !m_question) ask();
    if (m_question) m_question->raise();
    return false;
}

void ClosingQuestion::ask(const QString& why) {
    QStringList names;
    for (const RobotDescription* robot : drivingThemselves()) names += othersText(robot->title);
    const QString who = names.join(QStringLiteral(", "));
    m_question = new QMessageBox(&m_context.window);  // not modal: robots are driving
    m_question->setObjectName(QStringLiteral("closingQuestion"));
    m_question->setAttribute(Qt::WA_DeleteOnClose);
    m_question->setModal(false);
    m_question->setIcon(QMessageBox::Warning);
    m_question->setWindowTitle(tr("Close the station"));
    m_question->setText(why.isEmpty() ? tr("Driving by itself: %1").arg(who) : why);
    m_question->setInformativeText(tr(
        "Left driving, it goes on, and this station can stop it no more. Stopped, it stands until a station "
        "releases it. Robots that somebody drives from here stand in any case. Esc stops all robots at "
        "once."));
    const auto button = [this](const QString& text, const char* name, QMessageBox::ButtonRole role) {
        QPushButton* const made = m_question->addButton(text, role);
        made->setObjectName(QLatin1String(name));
        return made;
    };
    connect(button(tr("Stop and close"), "stopAndClose", QMessageBox::AcceptRole), &QPushButton::clicked,
            this, &ClosingQuestion::stopThem);
    connect(button(tr("Leave driving and close"), "leaveAndClose", QMessageBox::DestructiveRole),
            &QPushButton::clicked, this, &ClosingQuestion::close);
    QPushButton* const stay = button(tr("Cancel"), "stay", QMessageBox::RejectRole);
    m_question->setDefaultButton(stay);  // keys meant for driving close nothing
    m_question->show();
}

void ClosingQuestion::stopThem() {
    const auto robots = drivingThemselves();
    if (robots.empty()) return close();
    m_since = m_context.source.moment().steady;
    for (const RobotDescription* robot : robots) {
        m_stopping.insert(robot->name);
        m_context.station.stop(robot->name);
    }
    m_context.notify(tr("Closes as soon as they stand"));
}

void ClosingQuestion::follow(const LiveMoment& moment) {
    if (m_stopping.empty()) return;
    const bool late = moment.steady - m_since > StopPatience;
    std::erase_if(m_stopping, [&](const std::string& name) {
        const StopStage stage = stopLineOf({}, moment.view(name)).stage;
        // Some robots never report that they stand. A stop that a robot acknowledged holds without a station.
        return stage == StopStage::Standing || (late && stage == StopStage::Acknowledged);
    });
    if (m_stopping.empty()) return close();
    if (!late) return;
    m_stopping.clear();
    ask(tr("No answer to the stop. Close all the same?"));
}

void ClosingQuestion::close() {
    m_allowed = true;
    m_context.window.close();
}

}  // namespace leitstand
