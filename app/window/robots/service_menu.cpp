#include "app/window/robots/service_menu.h"

#include <algorithm>

#include <QAction>
#include <QMainWindow>
#include <QMenu>

#include "app/services/station/lines/robot_calls.h"
#include "app/services/station/station.h"
#include "app/window/commands/command_table.h"
#include "app/window/input/selection.h"
#include "widgets/models/others_text.h"

namespace leitstand {

ServiceMenu::ServiceMenu(const ViewContext& context, Station& station)
    : QObject(&context.window), m_context(context), m_station(station) {
    const auto& robots = context.selection.robots();
    const bool any = std::any_of(robots.begin(), robots.end(), [](const RobotDescription& robot) {
        return std::any_of(robot.services.begin(), robot.services.end(), isOperators);
    });
    if (!any) return;
    m_menu = context.commands.menu(CommandMenu::Robot).addMenu(tr("Se&rvices"));
    m_menu->setToolTipsVisible(true);
    connect(m_menu, &QMenu::aboutToShow, this, &ServiceMenu::fill);
}

void ServiceMenu::fill() {
    m_menu->clear();
    const RobotDescription* const robot = m_context.selection.robot();
    if (robot == nullptr) return;
    for (const ServiceDescription& service : robot->services) {
        if (!isOperators(service)) continue;
        const QString title = othersText(service.title.empty() ? service.name : service.title);
        if (serviceFacts(service.type)->kind == ServiceKind::Trigger) {
            add(title, service, true);
            continue;
        }
        add(tr("%1: on", "a service that switches something").arg(title), service, true);
        add(tr("%1: off", "a service that switches something").arg(title), service, false);
    }
    if (m_menu->isEmpty())
        m_menu->addAction(tr("%1 has none").arg(m_context.selection.face().title))->setEnabled(false);
}

void ServiceMenu::add(const QString& text, const ServiceDescription& service, bool value) {
    const std::string robot = m_context.selection.name().toStdString();
    QAction* const action = m_menu->addAction(text);
    action->setObjectName(QString::fromStdString(service.name) +
                          (value ? QString() : QStringLiteral(":off")));
    const bool offered = m_station.isOffered(robot, service.name);
    action->setEnabled(offered);
    const QString name = othersText(service.name);
    action->setToolTip(offered ? tr("Calls %1").arg(name) : tr("Nobody offers %1 now").arg(name));
    connect(action, &QAction::triggered, this, [this, robot, name = service.name, value] {
        if (const auto called = m_station.call(robot, name, value); !called)
            m_context.notify(QString::fromStdString(called.error().text));
    });
}

}  // namespace leitstand
