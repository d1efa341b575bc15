#include "app/window/live/map/map_actions.h"

#include <optional>

#include "app/services/station/station.h"
#include "app/services/station/station_mapping.h"
#include "app/window/live/live_bridge.h"
#include "app/window/live/map/decisions/decisions_feature.h"
#include "app/window/live/map/decisions/loops_feature.h"
#include "app/window/live/map/decisions/scanner_feature.h"
#include "app/window/live/map/decisions/submap_feature.h"
#include "app/window/live/map/go_to.h"
#include "app/window/live/map/map_feature.h"
#include "app/window/live/map/map_grant.h"
#include "app/window/live/map/place_robot.h"
#include "widgets/map_view/map_view.h"

namespace leitstand {

MapActions::MapActions(const LiveContext& context, MapFeature& map) : QObject(&map) {
    m_going = new GoTo(context, map.view(), map.gestures(), map.robots(), this);
    connect(m_going, &GoTo::told, this, &MapActions::told);
    connect(&map.view(), &MapView::groundActivated, m_going, [this](const Eigen::Vector3d& place) {
        m_going->go({place, std::nullopt});
    });
    auto* placing = new PlaceRobot(context, map.gestures(), map.robots(), this);
    connect(placing, &PlaceRobot::told, this, &MapActions::told);
    const MapContext deciding{context, context.bridge.station().mapping()};
    auto* decisions = new DecisionsFeature(deciding, map.view(), map.gestures(), map.robots(), this);
    connect(decisions, &DecisionsFeature::told, this, &MapActions::told);
    auto* scanners = new ScannerFeature(context, map.view(), this);
    connect(scanners, &ScannerFeature::told, this, &MapActions::told);
    auto* loops = new LoopsFeature(deciding, map.view(), this);
    connect(loops, &LoopsFeature::told, this, &MapActions::told);
    auto* submaps = new SubmapFeature(
        deciding, map.view(), map.gestures(), [decisions] { return decisions->chosen(); }, this);
    connect(submaps, &SubmapFeature::told, this, &MapActions::told);
    auto* grant = new MapGrantFeature(context, this);
    connect(grant, &MapGrantFeature::told, this, &MapActions::told);
}

void MapActions::go(const Eigen::Vector3d& place) {
    m_going->go({place, std::nullopt});
}

void MapActions::halt() {
    m_going->takeBack();
}

}  // namespace leitstand
