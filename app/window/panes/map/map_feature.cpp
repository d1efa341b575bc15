#include "app/window/panes/map/map_feature.h"

#include <chrono>
#include <utility>

#include <QAction>
#include <QApplication>
#include <QMainWindow>

#include "app/services/station/station.h"
#include "app/window/commands/command_table.h"
#include "app/window/input/selection.h"
#include "app/window/map/map_pane.h"
#include "app/window/map/view_commands.h"
#include "app/window/panes/map/grid_on_map.h"
#include "app/window/panes/map/links_on_map.h"
#include "app/window/panes/map/map_gestures.h"
#include "app/window/panes/map/robots_on_map.h"
#include "app/window/panes/map/storeys/storeys_feature.h"
#include "app/window/source/moment_source.h"
#include "widgets/map_view/map_readout.h"
#include "widgets/map_view/map_view.h"
#include "widgets/models/map/live_map_text.h"
#include "widgets/painting/theme.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds Rest(5);  ///< a pointer that rests longer does not show its point any more

}  // namespace

QString othersTitle(const GrantView& grant) {
    if (grant.mine || grant.holder.empty()) return {};
    return QString::fromStdString(grant.holderTitle.empty() ? grant.holder : grant.holderTitle);
}

MapFeature::MapFeature(const ViewContext& context, const MapViewSettings& view)
    : QObject(&context.window),
      m_context(context),
      m_view(view),
      m_pane(new MapPane(m_view, &context.window)) {
    m_pane->setHelpVisible(false);
    addCommands();
    connect(&context.source, &MomentSource::mapChanged, this, [this](const MapPtr& map) {
        m_map = map;
        m_pane->view().setMap(map);
    });
    connect(&m_pane->view(), &MapView::hovered, this, [this](const std::optional<PickedPoint>& point) {
        m_resting.start();
        showPointed(m_map ? pickText(point, *m_map) : QString());
    });
    // A pointer left on the map must not hide for long how the map grows.
    m_resting.setSingleShot(true);
    m_resting.setInterval(Rest);
    connect(&m_resting, &QTimer::timeout, this, [this] { showPointed({}); });
    connect(&context.source, &MomentSource::ticked, this, &MapFeature::showSummary);
    connect(&m_view, &ViewState::changed, this, [this](const MapViewSettings& settings) {
        if (settings.theme != m_pane->view().settings().theme) applyTheme(*qApp, settings.theme);
        m_pane->view().setSettings(settings);
        showSummaryNow();  // a paused review has no tick
    });
    m_pane->view().setSettings(m_view.settings());
    m_gestures = new MapGestures(m_pane->view(), this);
    m_robots = new RobotsOnMap(m_context, m_view, m_pane->view(), *m_gestures, this);
    new GridOnMap(m_context, m_pane->view(), this);
    new StoreysFeature(m_context, m_view, *m_pane, this);
    new LinksOnMap(m_context, m_pane->view(), this);
}

QWidget& MapFeature::pane() const {
    return *m_pane;
}

MapSummary MapFeature::summaryOf(const LiveMoment& moment) const {
    if (m_describe) return m_describe(moment);
    const bool follows = m_view.settings().follow != MapFollow::Free;
    LiveMapFacts facts{*moment.scans, *moment.places, moment.now};
    if (follows) facts.followed = m_context.selection.face().letter;
    if (m_context.liveStation != nullptr) facts.maker = othersTitle(m_context.liveStation->mapGrant());
    return liveSummaryOf(facts);
}

void MapFeature::showSummary(const LiveMoment& moment) {
    MapSummary summary = summaryOf(moment);
    if (m_robots != nullptr && !summary.hint.isEmpty() && !m_robots->details().isEmpty())
        summary.hint += QLatin1Char('\n') + m_robots->details();
    // The point under the pointer, but never in place of a doubt about the map.
    if (!m_pointed.isEmpty() && summary.tone == Tone::Normal)
        summary.result = summary.briefResult = m_pointed;
    m_pane->setSummary(summary);
}

void MapFeature::showPointed(const QString& point) {
    if (std::exchange(m_pointed, point) != point) showSummaryNow();
}

void MapFeature::showSummaryNow() {
    if (m_context.source.moment().scans && m_context.source.moment().places)
        showSummary(m_context.source.moment());
}

void MapFeature::describe(std::function<MapSummary(const LiveMoment&)> how) {
    m_describe = std::move(how);
    showSummaryNow();
}

void MapFeature::show(const MapSight& sight) {
    MapViewSettings settings = m_view.settings();
    settings.look = sight.look;
    settings.follow = sight.follow;
    m_pane->view().recall(settings);
    m_view.set(settings);
}

MapView& MapFeature::view() const {
    return m_pane->view();
}

void MapFeature::addCommands() {
    using Escape = ViewCommands::Escape;
    auto* looks =
        new ViewCommands(m_view, m_pane->view(), this, ViewCommands::Keys::Aside,
                         m_context.liveStation != nullptr ? Escape::StopsRobots : Escape::EndsMeasuring);
    looks->fill(m_context.commands.menu(CommandMenu::Map));
    m_context.commands.adopt(CommandMenu::Map);
    looks->setScans(0);
    looks->before().setVisible(false);  // scans of a live map have one pose
    connect(&m_context.source, &MomentSource::mapChanged, looks,
            [looks](const MapPtr& map) { looks->setScans(static_cast<int>(map->scans.size())); });
}

QStringList MapFeature::missing() const {
    if (m_pane->view().showsScans()) return {};
    return {tr("no scan is registered and drawn")};
}

}  // namespace leitstand
