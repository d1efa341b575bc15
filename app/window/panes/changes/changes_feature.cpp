#include "app/window/panes/changes/changes_feature.h"

#include <chrono>
#include <optional>

#include <QAction>
#include <QMainWindow>

#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/input/selection.h"
#include "app/window/panes/map/map_feature.h"
#include "app/window/source/live_moment.h"
#include "app/window/source/moment_source.h"
#include "widgets/changes/changes_panel.h"
#include "widgets/map_view/map_view.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds LookEvery(500);  ///< interval of looks for results

}  // namespace

ChangesFeature::ChangesFeature(const ViewContext& context, MapFeature& map)
    : QObject(&context.window), m_context(context), m_map(map), m_panel(new ChangesPanel(&context.window)) {
    m_panel->setObjectName(QStringLiteral("changesPane"));
    addCommands();
    connect(m_panel, &ChangesPanel::activated, this, &ChangesFeature::showChosen);
    connect(&context.source, &MomentSource::mapChanged, this, &ChangesFeature::setMap);
    connect(&m_look, &QTimer::timeout, this, &ChangesFeature::follow);
    m_look.start(LookEvery);
}

ChangesFeature::~ChangesFeature() = default;

QWidget& ChangesFeature::pane() const {
    return *m_panel;
}

void ChangesFeature::addCommands() {
    m_context.commands.separate(CommandMenu::Map);
    m_shown = &m_context.commands.add(
        {.id = QStringLiteral("changes.show"),
         .menu = CommandMenu::Map,
         .text = tr("What c&hanged"),
         .hint = tr("Colours and lists what came and what went since the missions before: in a map that is "
                    "put together from several"),
         .keys = QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_D),
         .checkable = true});
    m_shown->setEnabled(false);
    connect(m_shown, &QAction::toggled, this, &ChangesFeature::show);
    QAction& look = m_context.commands.add({.id = QStringLiteral("changes.place"),
                                            .menu = CommandMenu::Map,
                                            .text = tr("Show what chan&ged on the map"),
                                            .hint = tr("Moves the map to what is chosen in the list")});
    look.setIconText(tr("Show"));
    connect(&look, &QAction::triggered, this, &ChangesFeature::showChosen);
    m_panel->setCommands({&look});
}

void ChangesFeature::setMap(const MapPtr& map) {
    m_newest = map;
    const bool several = map && !visitsOf(countingScans(*map)).after.empty();
    m_shown->setEnabled(several);
    if (!several) m_shown->setChecked(false);
    follow();
}

void ChangesFeature::show(bool shown) {
    if (shown) m_context.panes.open(QStringLiteral("changes"));
    follow();
    m_map.view().setChanges(shown ? m_changes : nullptr);
}

void ChangesFeature::showChosen() {
    if (const auto chosen = m_panel->chosen()) return m_map.view().showPlace(chosen->inMap);
    m_context.notify(tr("Choose something in the list of what changed"));
}

void ChangesFeature::follow() {
    const bool wanted = m_shown->isChecked() || m_panel->isVisible();
    m_finder.want(wanted ? m_newest : nullptr);
    if (!wanted) return;
    const MapChangesPtr now = m_finder.changes();
    if (now != m_changes) {
        m_changes = now;
        if (m_shown->isChecked()) m_map.view().setChanges(m_changes);
    }
    if (m_panel->isVisible()) list();
}

void ChangesFeature::list() {
    std::optional<Pose> robot;
    const LiveMoment& moment = m_context.source.moment();
    for (const RobotInMap& one : moment.places ? *moment.places : RobotsInMap()) {
        if (one.robot == m_context.selection.name().toStdString() && one.placed) robot = one.baseInMap;
    }
    m_panel->show(m_changes.get(), robot);
}

}  // namespace leitstand
