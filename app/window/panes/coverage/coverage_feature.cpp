#include "app/window/panes/coverage/coverage_feature.h"

#include <chrono>
#include <utility>
#include <vector>

#include <QAction>
#include <QActionGroup>
#include <QMainWindow>

#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/input/selection.h"
#include "app/window/panes/map/map_actions.h"
#include "app/window/panes/map/map_feature.h"
#include "app/window/source/moment_source.h"
#include "widgets/coverage/missed_panel.h"
#include "widgets/map_view/map_view.h"
#include "widgets/models/coverage/missed_model.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds LookEvery(500);  ///< interval of looks for results

/// Returns the data of an overlay's command. Below 0: none is shown.
int dataOf(std::optional<SearchSensor> sensor) {
    return sensor ? static_cast<int>(*sensor) : -1;
}

}  // namespace

CoverageFeature::CoverageFeature(const ViewContext& context, MapFeature& map, Source searched,
                                 MapActions* actions)
    : QObject(&context.window),
      m_context(context),
      m_map(map),
      m_source(std::move(searched)),
      m_panel(new MissedPanel(&context.window)),
      m_overlays(new QActionGroup(this)) {
    m_panel->setObjectName(QStringLiteral("missedPane"));
    addOverlays();
    std::vector<QAction*> buttons = {addMissed()};
    if (actions != nullptr) buttons.push_back(m_goTo = addGoTo(*actions));
    m_panel->setCommands(buttons);
    connect(m_panel, &MissedPanel::sensorChosen, this, [this](SearchSensor sensor) {
        if (m_shown) return showOverlay(sensor);
        refresh();
    });
    connect(m_panel, &MissedPanel::activated, this, &CoverageFeature::showChosen);
    connect(m_panel, &MissedPanel::chosenChanged, this, [this] {
        if (m_goTo != nullptr) m_goTo->setEnabled(m_panel->chosen().has_value());
    });
    // Not with the moments: a paused review emits only one.
    connect(&m_look, &QTimer::timeout, this, &CoverageFeature::follow);
    m_look.start(LookEvery);
}

QWidget& CoverageFeature::pane() const {
    return *m_panel;
}

void CoverageFeature::addOverlays() {
    m_context.commands.separate(CommandMenu::Map);
    const auto add = [this](const char* id, const QString& text, const QString& hint,
                            std::optional<SearchSensor> sensor) {
        QAction& action = m_context.commands.add({.id = QString::fromLatin1(id),
                                                  .menu = CommandMenu::Map,
                                                  .text = text,
                                                  .hint = hint,
                                                  .checkable = true});
        action.setData(dataOf(sensor));
        action.setChecked(!sensor);
        m_overlays->addAction(&action);
        connect(&action, &QAction::triggered, this, [this, sensor] { showOverlay(sensor); });
    };
    add("coverage.off", tr("Searched floor: &hidden"), tr("The map as it is"), std::nullopt);
    add("coverage.scanner", tr("Searched by s&canner"),
        tr("Tints the floor where a body would have enough points, hatches what was missed"),
        SearchSensor::Scanner);
    add("coverage.camera", tr("Searched by came&ra"),
        tr("Tints the floor where a body would span enough pixels of a camera, hatches what was missed"),
        SearchSensor::Camera);
    add("coverage.infrared", tr("Searched by i&nfrared"),
        tr("Tints the floor where a body would span enough pixels of an infrared camera, hatches what was "
           "missed"),
        SearchSensor::Infrared);
    QAction& next = m_context.commands.add({.id = QStringLiteral("coverage.next"),
                                            .menu = CommandMenu::Map,
                                            .text = tr("Searched floor: ne&xt sensor"),
                                            .hint = tr("Scanner, camera, infrared, hidden"),
                                            .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C)});
    connect(&next, &QAction::triggered, this, [this] {
        const int now = dataOf(m_shown) + 1;
        const bool more = now < static_cast<int>(SearchSensors.size());
        showOverlay(more ? std::optional(static_cast<SearchSensor>(now)) : std::nullopt);
    });
}

/// Adds the commands of the list of what was missed. Returns the one that shows a piece on the map.
QAction* CoverageFeature::addMissed() {
    QAction& open = m_context.commands.add(
        {.id = QStringLiteral("coverage.missed"),
         .menu = CommandMenu::Map,
         .text = tr("&What did I miss?"),
         .hint = tr("Lists the floor that robots can reach and that was not seen, the largest piece first"),
         .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_L)});
    connect(&open, &QAction::triggered, this, &CoverageFeature::showMissed);
    QAction& look = m_context.commands.add({.id = QStringLiteral("coverage.show"),
                                            .menu = CommandMenu::Map,
                                            .text = tr("Show what was missed on the ma&p"),
                                            .hint = tr("Moves the map to the chosen place")});
    look.setIconText(tr("Show"));
    connect(&look, &QAction::triggered, this, &CoverageFeature::showChosen);
    return &look;
}

QAction* CoverageFeature::addGoTo(MapActions& actions) {
    QAction& goTo = m_context.commands.add({.id = QStringLiteral("coverage.goTo"),
                                            .menu = CommandMenu::Map,
                                            .text = tr("Go to what was &missed"),
                                            .hint = tr("Sends the selected robot to the chosen place")});
    goTo.setIconText(tr("Go there"));
    goTo.setEnabled(false);
    connect(&goTo, &QAction::triggered, this, [this, &actions] {
        if (const auto chosen = m_panel->chosen()) actions.go(chosen->inMap);
    });
    return &goTo;
}

void CoverageFeature::showOverlay(std::optional<SearchSensor> sensor) {
    m_shown = sensor;
    if (sensor) m_panel->setSensor(*sensor);
    for (QAction* action : m_overlays->actions())
        action->setChecked(action->data().toInt() == dataOf(sensor));
    if (sensor) m_searched = m_source(m_context.source.moment());
    refresh();
}

void CoverageFeature::showMissed() {
    m_searched = m_source(m_context.source.moment());
    refresh();
    m_context.panes.open(QStringLiteral("missed"));
    if (!m_shown) showOverlay(m_panel->sensor());
    m_panel->chooseFirst();
    m_panel->setFocus();
    if (m_panel->chosen()) return showChosen();
    m_context.notify(emptyText(m_searched.get(), m_panel->sensor()));
}

void CoverageFeature::showChosen() {
    if (const auto chosen = m_panel->chosen()) return m_map.view().showPlace(chosen->inMap);
    m_context.notify(tr("Choose a place in the list of what was missed"));
}

void CoverageFeature::follow() {
    if (!m_shown && !m_panel->isVisible()) return;
    SearchedFloorPtr now = m_source(m_context.source.moment());
    const bool news = now != m_searched;
    m_searched = std::move(now);
    if (news) return refresh();
    if (m_panel->isVisible()) list();  // updates distances from the robot
}

void CoverageFeature::refresh() {
    list();
    m_map.view().setFloorTint(m_shown ? tintOf(m_searched, *m_shown) : nullptr);
}

void CoverageFeature::list() {
    std::optional<Pose> robot;
    const LiveMoment& moment = m_context.source.moment();
    for (const RobotInMap& one : moment.places ? *moment.places : RobotsInMap()) {
        if (one.robot == m_context.selection.name().toStdString() && one.placed) robot = one.baseInMap;
    }
    m_panel->show(m_searched, robot);
}

}  // namespace leitstand
