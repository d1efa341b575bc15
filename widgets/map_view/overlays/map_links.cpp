#include "widgets/map_view/overlays/map_links.h"

#include <algorithm>
#include <optional>

#include <QPainter>

#include "widgets/map_view/camera/map_camera.h"
#include "widgets/map_view/overlays/overlay_style.h"
#include "widgets/map_view/scene/scene_content.h"

namespace leitstand {
namespace {

/// Returns the position of scan @p id on screen; empty: not shown, or behind the eye.
std::optional<QPointF> placeOf(std::uint64_t id, const MapProjection& projection,
                               const SceneContent& content) {
    // Scans are sorted by id.
    const auto scan =
        std::lower_bound(content.scans.begin(), content.scans.end(), id,
                         [](const SceneScan& one, std::uint64_t wanted) { return one.id < wanted; });
    if (scan == content.scans.end() || scan->id != id || !scan->visible) return std::nullopt;
    const auto seen = projection.project(scan->poseInMap.translation());
    return seen ? std::optional(seen->position) : std::nullopt;
}

QPen penOf(MapLink::Standing standing, const OverlayStyle& style) {
    constexpr double Wide = 2.5;  // [px]
    switch (standing) {
        case MapLink::Standing::Open:
            return {asColour(style.colours.openLink), Wide, Qt::DashLine};
        case MapLink::Standing::Refused:
            return {asColour(style.colours.refusedLink), Wide, Qt::DotLine};
        case MapLink::Standing::Counts:
            break;
    }
    return {asColour(style.colours.link), Wide};
}

}  // namespace

void paintLinks(QPainter& painter, const MapProjection& projection, const SceneContent& content,
                std::span<const MapLink> links, const OverlayStyle& style) {
    for (const MapLink& link : links) {
        const auto from = placeOf(link.from, projection, content), to = placeOf(link.to, projection, content);
        if (!from || !to) continue;
        painter.setPen(penOf(link.standing, style));
        painter.drawLine(*from, *to);
    }
}

}  // namespace leitstand
