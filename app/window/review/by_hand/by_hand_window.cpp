#include "app/window/review/by_hand/by_hand_window.h"

#include <algorithm>

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QIcon>
#include <QToolButton>

#include "app/window/commands/command_table.h"
#include "app/window/commands/help_commands.h"
#include "app/window/frame/key_columns.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/frame/window_frame.h"
#include "app/window/input/selection.h"
#include "app/window/panes/map/map_feature.h"
#include "app/window/panes/pane_table.h"
#include "app/window/review/by_hand/by_hand_bridge.h"
#include "core/settings/window_layout.h"
#include "widgets/map_view/map_view.h"
#include "widgets/painting/elided_label.h"
#include "widgets/painting/plain_texts.h"
#include "widgets/painting/theme.h"

namespace leitstand {
namespace {

constexpr int LeastName = 150;  ///< least width of the mission's name in the bar [px]

/// Returns the window's layout: the map, and its scans beside it.
WindowLayout arrangement() {
    WindowLayout layout;
    layout.panes.parts = {{.pane = "map", .share = 3.0}, {.pane = "key-scans"}};
    return layout;
}

}  // namespace

ByHandWindow::ByHandWindow(ByHandBridge& bridge, const MapViewSettings& view, QWidget* parent)
    : QMainWindow(parent), m_bridge(bridge) {
    keepTextsPlain();
    applyTheme(*qApp, view.theme);  // before widgets exist, which would have to be styled again
    setWindowTitle(tr("%1 – map by hand – Leitstand")
                       .arg(QString::fromStdString(bridge.hand().folder().filename().string())));
    setWindowIcon(QIcon(QStringLiteral(":/leitstand/icons/leitstand.svg")));
    m_selection = new Selection(bridge.robots(), this);
    m_commands = new CommandTable(*this);
    m_panes = new PaneDocks(this);
    const MapContext context{{m_bridge, *m_selection, *m_commands, *m_panes, *this}, bridge.hand().mapping()};
    m_map = makePanes(context, view).map;
    connect(&bridge, &MomentSource::notified, this,
            [this](const QString& text) { m_frame->showMessage(text); });
    (new HelpCommands(*this, KeyColumns::mapByHand()))->fill(m_commands->menu(CommandMenu::Help));
    m_commands->adopt(CommandMenu::Help);
    build();
    m_panes->arrange(arrangement());
    bridge.begin();
}

ByHandWindow::~ByHandWindow() {
    // Signals that features emit during destruction reach nobody.
    m_bridge.disconnect(this);
    for (QObject* part : children()) part->disconnect(this);
}

void ByHandWindow::build() {
    QAction& done = m_commands->add(
        {.id = QStringLiteral("byHand.done"),
         .menu = CommandMenu::Mission,
         .text = tr("Back to the &review"),
         .hint = tr("The review opens again, on the map as it is now. What was decided here is "
                    "in the mission, and can be taken back here, also later"),
         .keys = QKeySequence(Qt::CTRL | Qt::Key_W)});
    connect(&done, &QAction::triggered, this, &QWidget::close);
    auto* const name = new ElidedLabel(
        tr("MAP BY HAND · %1").arg(QString::fromStdString(m_bridge.hand().folder().filename().string())),
        this);
    name->setObjectName(QStringLiteral("byHandName"));
    name->setToolTip(QString::fromStdString(m_bridge.hand().folder().string()));
    name->setMinimumWidth(std::min(LeastName, name->sizeHint().width()));
    auto* const back = new QToolButton(this);
    back->setObjectName(QStringLiteral("byHandDone"));
    back->setDefaultAction(&done);
    back->setToolButtonStyle(Qt::ToolButtonTextOnly);
    m_frame = new WindowFrame(*this);
    m_frame->build({{name, GivesWay::LittleByLittle}}, {{back}}, *m_panes);
    m_panes->setFocus();
}

MapView& ByHandWindow::mapView() const {
    return m_map->view();
}

const MapViewSettings& ByHandWindow::view() const {
    return m_map->settings();
}

QString ByHandWindow::newest() const {
    return m_frame->newest();
}

QStringList ByHandWindow::missing() const {
    return m_map->missing();
}

void ByHandWindow::showMessage(const QString& text) {
    m_bridge.notify(text);
}

void ByHandWindow::closeEvent(QCloseEvent* event) {
    emit closing();
    QMainWindow::closeEvent(event);
}

}  // namespace leitstand
