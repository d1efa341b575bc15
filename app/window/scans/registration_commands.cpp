#include "app/window/scans/registration_commands.h"

#include <QMenu>

#include "app/window/commands/make_action.h"
#include "app/window/scans/session_bridge.h"

namespace leitstand {

RegistrationCommands::RegistrationCommands(SessionBridge& session, QObject* parent)
    : QObject(parent), m_session(session) {
    m_again =
        makeAction({"again", tr("Register &again"), tr("Registers all scans again with the present settings"),
                    QKeySequence(Qt::Key_F5), "again"},
                   this);
    m_cancel = makeAction({"cancel", tr("&Cancel"), tr("Ends reading and registering"),
                           QKeySequence(Qt::SHIFT | Qt::Key_F5), "cancel"},
                          this);
    connect(m_again, &QAction::triggered, this, &RegistrationCommands::againRequested);
    connect(m_cancel, &QAction::triggered, &session, &SessionBridge::cancel);
    connect(&session, &SessionBridge::busyChanged, this, &RegistrationCommands::showState);
    showState();
}

void RegistrationCommands::fill(QMenu& menu, QAction& before) {
    menu.addActions({m_again, m_cancel});
    menu.addSeparator();
    menu.addAction(&before);
}

void RegistrationCommands::setScans(int scans) {
    m_scans = scans;
    showState();
}

void RegistrationCommands::showState() {
    m_again->setEnabled(m_scans > 1 && !m_session.busy());
    m_cancel->setEnabled(m_session.busy());
}

}  // namespace leitstand
