#pragma once

#include <map>
#include <string>

#include <QObject>

#include "app/window/panes/view_context.h"

namespace leitstand {

class MapView;
struct LiveMoment;

/// The grid map or costmap of the selected robot's own that lies over the map. The operator goes through
/// them; none is shown at first.
class GridOnMap final : public QObject {
    Q_OBJECT
public:
    GridOnMap(const ViewContext& context, MapView& view, QObject* parent);

private:
    void showNext();
    void show(const LiveMoment& moment);

    ViewContext m_context;
    MapView& m_view;
    std::map<std::string, std::string> m_topics;  ///< of the grids that are shown, by robot
};

}  // namespace leitstand
