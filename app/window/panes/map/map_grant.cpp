#include "app/window/panes/map/map_grant.h"

#include <utility>

#include <QAction>

#include "app/services/station/station.h"
#include "app/window/commands/command_table.h"
#include "app/window/panes/map/map_feature.h"
#include "app/window/source/moment_source.h"

namespace leitstand {

MapGrantFeature::MapGrantFeature(const LiveContext& context, QObject* parent)
    : QObject(parent),
      m_context(context),
      m_give(&context.commands.add({.id = "map.give",
                                    .menu = CommandMenu::Map,
                                    .text = tr("Hand the map over"),
                                    .hint = tr("Another station registers the scans from now on, and decides "
                                               "on them; this one goes on showing its map")})) {
    m_give->setEnabled(false);
    connect(m_give, &QAction::triggered, this, &MapGrantFeature::give);
    connect(&context.source, &MomentSource::ticked, this, &MapGrantFeature::show);
}

void MapGrantFeature::give() {
    m_context.station.giveMap();
    show();
}

void MapGrantFeature::show() {
    const GrantView grant = m_context.station.mapGrant();
    const bool wanted = grant.mine && !grant.requestedBy.empty();
    m_give->setEnabled(wanted);
    const QString text =
        wanted ? tr("Hand the map over to %1")
                     .arg(QString::fromStdString(grant.requestedByTitle.empty() ? grant.requestedBy
                                                                                : grant.requestedByTitle))
               : tr("Hand the map over");
    if (m_give->text() != text) m_give->setText(text);
    const QString maker = othersTitle(grant);
    if (std::exchange(m_maker, maker) == maker) return;
    if (!maker.isEmpty())
        m_context.notify(tr("%1 makes the map: it is shown here, and decided on there").arg(maker));
    else if (grant.mine)
        m_context.notify(tr("The map is made here"));
}

}  // namespace leitstand
