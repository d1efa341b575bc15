#pragma once

#include <QMainWindow>

#include "app/window/map/view_state.h"
#include "app/window/scans/session_bridge.h"
#include "app/window/shell/window_state.h"
#include "widgets/models/message_list_model.h"
#include "widgets/models/scan_list_model.h"

namespace leitstand {

class BottomStrip;
class FileCommands;
class MapPane;
class MapView;
class RegistrationCommands;
class RegistrationPanel;
class ViewCommands;

/// The window for files of scans. Connects session, models, panels and commands.
class MainWindow final : public QMainWindow {
    Q_OBJECT
public:
    /// Creates a window with the state @p state.
    explicit MainWindow(const WindowState& state, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Reads and registers @p sources.
    void open(const Sources& sources);
    /// Returns everything that was opened and not closed again.
    [[nodiscard]] const Sources& sources() const { return m_sources; }
    /// Returns the state to be stored. What is only used by other windows has its default.
    [[nodiscard]] WindowState state() const;
    /// Returns whether nothing is being read or registered.
    [[nodiscard]] bool idle() const { return !m_session.busy(); }
    [[nodiscard]] MapView& mapView() const;
    [[nodiscard]] ViewState& view() { return m_view; }
    [[nodiscard]] const ScanListModel& scans() const { return m_scans; }
    [[nodiscard]] const MessageListModel& messages() const { return m_messages; }

signals:
    /// An error was added to the messages.
    void failed(const QString& why);
    /// All work has ended.
    void becameIdle();
    /// The window is about to close.
    void closing();
    void languageWanted(const QString& code);  ///< requests a new window in this language

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void addDocks(const WindowState& state);
    void addMenus();
    void connectSession();
    void connectMap();
    void connectCommands();
    void showMap(const MapPtr& map);
    void showView(const MapViewSettings& settings);
    void addMessage(MessageListModel::Severity severity, const QString& text);
    void restore(const WindowState& state);

    ScanListModel m_scans;
    MessageListModel m_messages;
    ViewState m_view;
    SessionBridge m_session;
    Sources m_sources;
    MapPane* m_pane;
    FileCommands* m_files;
    ViewCommands* m_viewCommands;
    RegistrationCommands* m_registration;
    RegistrationPanel* m_settings = nullptr;
    BottomStrip* m_strip = nullptr;
    QDockWidget* m_scansDock = nullptr;
    QDockWidget* m_settingsDock = nullptr;
    QDockWidget* m_messagesDock = nullptr;
};

}  // namespace leitstand
