#include "app/window/panes/map/map_actions.h"

#include <optional>

#include "app/services/station/station.h"
#include "app/services/station/station_mapping.h"
#include "app/window/panes/map/decisions/decisions_feature.h"
#include "app/window/panes/map/decisions/loops_feature.h"
#include "app/window/panes/map/decisions/scanner_feature.h"
#include "app/window/panes/map/decisions/submap_feature.h"
#include "app/window/panes/map/go_to.h"
#include "app/window/panes/map/map_feature.h"
#include "app/window/panes/map/map_grant.h"
#include "app/window/panes/map/place_robot.h"
#include "app/window/source/moment_source.h"
#include "widgets/map_view/map_view.h"

namespace leitstand {

MapActions::MapActions(const LiveContext& context, MapFeature& map) : QObject(&map) {
    m_going = new GoTo(context, map.view(), map.gestures(), map.robots(), this);
    connect(&map.view(), &MapView::groundActivated, m_going, [this](const Eigen::Vector3d& place) {
        m_going->go({place, std::nullopt});
    });
    new PlaceRobot(context, map.gestures(), map.robots(), this);
    const MapContext deciding{context, context.station.mapping()};
    m_decisions = new DecisionsFeature(deciding, map.view(), map.gestures(), map.robots(), this);
    new ScannerFeature(context, map.view(), this);
    new LoopsFeature(deciding, map.view(), this);
    new SubmapFeature(
        deciding, map.view(), map.gestures(), [this] { return m_decisions->chosen(); }, this);
    new MapGrantFeature(context, this);
}

QWidget& MapActions::keyScans() const {
    return m_decisions->pane();
}

void MapActions::go(const Eigen::Vector3d& place) {
    m_going->go({place, std::nullopt});
}

void MapActions::halt() {
    m_going->takeBack();
}

}  // namespace leitstand
