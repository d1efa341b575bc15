#include "app/window/panes/map/links_on_map.h"

#include <cstdint>
#include <map>
#include <vector>

#include <QAction>

#include "app/window/commands/command_table.h"
#include "app/window/source/live_moment.h"
#include "app/window/source/moment_source.h"
#include "core/event/scan_links.h"
#include "widgets/map_view/map_view.h"

namespace leitstand {
namespace {

/// First scan of the part of the map that a key scan belongs to, by the key scan's id.
using Parts = std::map<std::uint64_t, std::uint64_t>;

MapLink::Standing standingOf(const Link& link, const Parts& parts) {
    const auto from = parts.find(link.from), to = parts.find(link.to);
    // The link that joined their parts was taken back.
    const bool apart = from != parts.end() && to != parts.end() && from->second != to->second;
    if (link.active && apart) return MapLink::Standing::Open;
    if (link.active) return MapLink::Standing::Counts;
    return link.kind == LinkKind::Operator ? MapLink::Standing::Refused : MapLink::Standing::Open;
}

}  // namespace

LinksOnMap::LinksOnMap(const ViewContext& context, MapView& view, QObject* parent)
    : QObject(parent), m_context(context), m_view(view) {
    m_shown = &m_context.commands.add(
        {.id = QStringLiteral("map.links"),
         .menu = CommandMenu::Map,
         .text = tr("Where the map meets &itself"),
         .hint = tr("Lines between scans that see the same place: solid where the map follows them, dashed "
                    "where it was asked or they were taken back, dotted where somebody said no"),
         .checkable = true});
    connect(m_shown, &QAction::toggled, this, [this] { follow(m_context.source.moment()); });
    connect(&context.source, &MomentSource::ticked, this, [this](const LiveMoment& moment) {
        if (m_shown->isChecked()) follow(moment);
    });
}

void LinksOnMap::follow(const LiveMoment& moment) {
    std::vector<MapLink> links;
    if (m_shown->isChecked() && moment.mission) {
        Parts parts;
        if (moment.scans) {
            for (const LiveKeyScan& scan : moment.scans->scans) parts.emplace(scan.id, scan.part);
        }
        for (const Link& link : loopsOf(*moment.mission))
            links.push_back({link.from, link.to, standingOf(link, parts)});
    }
    m_view.setLinks(std::move(links));
}

}  // namespace leitstand
