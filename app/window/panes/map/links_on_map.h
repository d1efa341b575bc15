#pragma once

#include <QObject>

#include "app/window/panes/view_context.h"

class QAction;

namespace leitstand {

class MapView;
struct LiveMoment;

/// A command that shows where the map has loops: as lines over the map, between scans that see the same
/// place.
class LinksOnMap final : public QObject {
    Q_OBJECT
public:
    LinksOnMap(const ViewContext& context, MapView& view, QObject* parent);

private:
    void follow(const LiveMoment& moment);

    ViewContext m_context;
    MapView& m_view;
    QAction* m_shown;
};

}  // namespace leitstand
