#include "app/window/scans/main_window.h"

#include <algorithm>

#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QStatusBar>

#include "app/window/commands/help_commands.h"
#include "app/window/commands/language_commands.h"
#include "app/window/map/map_pane.h"
#include "app/window/map/view_commands.h"
#include "app/window/scans/bottom_strip.h"
#include "app/window/scans/file_commands.h"
#include "app/window/scans/registration_commands.h"
#include "app/window/scans/scan_drop.h"
#include "widgets/map_view/map_readout.h"
#include "widgets/map_view/map_view.h"
#include "widgets/messages/messages_panel.h"
#include "widgets/models/map_text.h"
#include "widgets/painting/plain_texts.h"
#include "widgets/painting/theme.h"
#include "widgets/scans/registration_panel.h"
#include "widgets/scans/scans_panel.h"

namespace leitstand {
namespace {

constexpr int SideWidth = 420, WidestSide = 600, ScansHeight = 320, SettingsHeight = 420,
              MessagesHeight = 96;  ///< [px]

QDockWidget* makeDock(const QString& title, const QString& name, QWidget* content, QKeySequence keys,
                      QMainWindow* window) {
    auto* dock = new QDockWidget(title, window);
    dock->setObjectName(name);
    auto* head = new QLabel(title, dock);
    head->setProperty("title", true);
    dock->setTitleBarWidget(head);
    content->setAttribute(Qt::WA_StyledBackground);
    dock->setWidget(content);
    dock->toggleViewAction()->setShortcut(keys);
    return dock;
}

/// Applies the theme before widgets exist, which would have to be styled again. Returns @p view.
const MapViewSettings& themed(const MapViewSettings& view) {
    applyTheme(*qApp, view.theme);
    return view;
}

}  // namespace

MainWindow::MainWindow(const WindowState& state, QWidget* parent)
    : QMainWindow(parent), m_view(themed(state.view)), m_pane(new MapPane(m_view, this)) {
    keepTextsPlain();
    setWindowTitle(tr("Leitstand"));
    setWindowIcon(QIcon(QStringLiteral(":/leitstand/icons/leitstand.svg")));
    setCentralWidget(m_pane);
    m_files = new FileCommands(*this, state.recent, [this] { return mapView().picture(); });
    m_viewCommands = new ViewCommands(m_view, mapView(), this);
    m_registration = new RegistrationCommands(m_session, this);
    m_pane->setTools(m_viewCommands->tools());
    addDocks(state);
    addMenus();
    m_strip =
        new BottomStrip(m_registration->cancel(), *m_messagesDock->toggleViewAction(), m_messages, this);
    statusBar()->setSizeGripEnabled(false);
    statusBar()->setContentsMargins(0, 0, 0, 0);
    statusBar()->addWidget(m_strip, 1);
    connectSession();
    connectMap();
    connectCommands();
    showMap(m_scans.map());
    showView(m_view.settings());
    restore(state);
}

MainWindow::~MainWindow() = default;

MapView& MainWindow::mapView() const {
    return m_pane->view();
}

void MainWindow::addDocks(const WindowState& state) {
    m_settings = new RegistrationPanel(m_registration->again(), m_viewCommands->before(), this);
    m_settings->setSettings(state.registration);
    m_scansDock = makeDock(tr("Scans"), QStringLiteral("scansDock"), new ScansPanel(m_scans, this),
                           QKeySequence(Qt::Key_F7), this);
    m_settingsDock = makeDock(tr("Registration"), QStringLiteral("registrationDock"), m_settings,
                              QKeySequence(Qt::Key_F8), this);
    m_messagesDock = makeDock(tr("Messages"), QStringLiteral("messagesDock"),
                              new MessagesPanel(m_messages, this), QKeySequence(Qt::Key_F4), this);
    m_messagesDock->toggleViewAction()->setToolTip(tr("Shows or hides the messages (F4)"));
    addDockWidget(Qt::RightDockWidgetArea, m_scansDock);
    addDockWidget(Qt::RightDockWidgetArea, m_settingsDock);
    addDockWidget(Qt::BottomDockWidgetArea, m_messagesDock);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    m_messagesDock->hide();
}

void MainWindow::addMenus() {
    m_files->fill(*menuBar()->addMenu(tr("&File")));
    QMenu* view = menuBar()->addMenu(tr("&View"));
    m_viewCommands->fill(*view);
    view->addSeparator();
    for (QDockWidget* dock : {m_scansDock, m_settingsDock, m_messagesDock}) {
        view->addAction(dock->toggleViewAction());
    }
    addLanguages(*view, [this](const QString& code) { emit languageWanted(code); });
    m_registration->fill(*menuBar()->addMenu(tr("&Registration")), m_viewCommands->before());
    (new HelpCommands(*this))->fill(*menuBar()->addMenu(tr("&Help")));
}

void MainWindow::connectSession() {
    connect(&m_session, &SessionBridge::mapChanged, this, &MainWindow::showMap);
    connect(&m_session, &SessionBridge::progressed, m_strip, &BottomStrip::showProgress);
    connect(&m_session, &SessionBridge::notified, this, [this](const SessionMessage& message) {
        const bool error = message.severity == SessionMessage::Severity::Error;
        addMessage(error ? MessageListModel::Severity::Error : MessageListModel::Severity::Warning,
                   QString::fromStdString(message.text));
    });
    connect(&m_session, &SessionBridge::busyChanged, this, [this](bool busy) {
        if (busy) return;
        m_strip->hideProgress();
        m_pane->setHelpVisible(m_scans.rowCount() == 0);
        emit becameIdle();
    });
}

void MainWindow::connectMap() {
    connect(&m_scans, &ScanListModel::visibilityChanged, &mapView(),
            [this](const std::vector<bool>& visible) { mapView().setVisible(visible); });
    connect(&mapView(), &MapView::hovered, m_strip, [this](const std::optional<PickedPoint>& point) {
        m_strip->setPick(pickText(point, *m_scans.map()));
    });
    connect(&mapView(), &MapView::measured, m_strip, [this](const Measurement& measurement) {
        m_strip->setMeasurement(measurementText(measurement));
    });
    connect(&m_viewCommands->measure(), &QAction::toggled, m_strip, [this](bool on) {
        m_strip->setMeasurement(on ? tr("Click two points of the map · Esc ends measuring") : QString());
    });
    connect(&mapView(), &MapView::failed, this,
            [this](const QString& why) { addMessage(MessageListModel::Severity::Error, why); });
    connect(&m_view, &ViewState::changed, this, &MainWindow::showView);
}

void MainWindow::connectCommands() {
    connect(m_files, &FileCommands::openRequested, this, [this](const Sources& sources) {
        m_pane->setHelpVisible(false);
        m_sources.insert(m_sources.end(), sources.begin(), sources.end());
        m_session.open(sources, m_settings->settings());
    });
    connect(m_files, &FileCommands::closeRequested, this, [this] {
        m_sources.clear();
        m_session.clear();
    });
    connect(m_files, &FileCommands::pictureSaved, m_strip,
            [this](const QString& file) { m_strip->setNote(tr("Saved %1").arg(file)); });
    connect(m_files, &FileCommands::failed, this,
            [this](const QString& why) { addMessage(MessageListModel::Severity::Error, why); });
    connect(m_registration, &RegistrationCommands::againRequested, this,
            [this] { m_session.registerAgain(m_settings->settings()); });
    connect(new ScanDrop(*this), &ScanDrop::dropped, m_files, &FileCommands::open);
}

void MainWindow::open(const Sources& sources) {
    m_files->open(sources);
}

void MainWindow::showMap(const MapPtr& map) {
    m_scans.setMap(map);
    mapView().setMap(map);
    mapView().setVisible(m_scans.visible());
    m_pane->setSummary(summaryOf(*map));
    m_pane->setHelpVisible(map->scans.empty() && idle());
    m_files->setMapEmpty(map->scans.empty());
    m_registration->setScans(static_cast<int>(map->scans.size()));
    m_viewCommands->setScans(static_cast<int>(map->scans.size()));
}

void MainWindow::showView(const MapViewSettings& settings) {
    if (settings.theme != mapView().settings().theme) applyTheme(*qApp, settings.theme);
    mapView().setSettings(settings);
}

void MainWindow::addMessage(MessageListModel::Severity severity, const QString& text) {
    m_messages.add(severity, text);
    if (severity != MessageListModel::Severity::Error) return;
    m_messagesDock->show();
    emit failed(text);
}

void MainWindow::restore(const WindowState& state) {
    if (state.geometry.isEmpty() || !restoreGeometry(state.geometry)) resize(state.firstSize);
    const int side = std::clamp(width() * 3 / 10, SideWidth, WidestSide);
    resizeDocks({m_scansDock, m_settingsDock}, {side, side}, Qt::Horizontal);
    // The settings take what they need, the list of scans grows with the window.
    const int settings = std::max(SettingsHeight, m_settingsDock->sizeHint().height());
    resizeDocks({m_scansDock, m_settingsDock}, {std::max(ScansHeight, height() - settings), settings},
                Qt::Vertical);
    resizeDocks({m_messagesDock}, {MessagesHeight}, Qt::Vertical);
    if (!state.layout.isEmpty()) restoreState(state.layout);
    m_messagesDock->hide();
}

WindowState MainWindow::state() const {
    WindowState state;
    state.geometry = saveGeometry();
    state.layout = saveState();
    state.view = m_view.settings();
    state.registration = m_settings->settings();
    state.recent = m_files->recent();
    return state;
}

void MainWindow::closeEvent(QCloseEvent* event) {
    m_session.cancel();
    emit closing();
    QMainWindow::closeEvent(event);
}

}  // namespace leitstand
