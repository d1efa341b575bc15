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
    /// Cancels the work of @p session and follows its state. @p session must outlive this object.
    RegistrationCommands(SessionBridge& session, QObject* parent);

    /// Puts the commands and @p before (ViewCommands::before()) into @p menu.
    void fill(QMenu& menu, QAction& before);
    [[nodiscard]] QAction& again() const { return *m_again; }
    [[nodiscard]] QAction& cancel() const { return *m_cancel; }
    /// Takes the number of scans in the map. Registering again is enabled if there are at least two scans and
    /// no work is in progress.
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
