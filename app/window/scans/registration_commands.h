#pragma once

#include <QObject>

class QAction;
class QMenu;

namespace leitstand {

class SessionBridge;

/// The Registration menu: registering again and cancelling.
class RegistrationCommands final : public QObject {
    Q_OBJECT
public:
    /// Cancels and follows @p session, which must outlive it.
    RegistrationCommands(SessionBridge& session, QObject* parent);

    /// Puts the commands into @p menu, together with @p before.
    void fill(QMenu& menu, QAction& before);
    [[nodiscard]] QAction& again() const { return *m_again; }
    [[nodiscard]] QAction& cancel() const { return *m_cancel; }
    /// Enables registering again for two scans or more.
    void setScans(int scans);

signals:
    void againRequested();

private:
    void showState();

    SessionBridge& m_session;
    int m_scans = 0;
    QAction* m_again;
    QAction* m_cancel;
};

}  // namespace leitstand
