#pragma once

#include <Eigen/Core>
#include <QObject>

#include "app/window/panes/view_context.h"

class QWidget;

namespace leitstand {

class DecisionsFeature;
class GoTo;
class MapFeature;

/// What the operator can do on the map with live robots and their scans: send robots, place them, decide.
class MapActions final : public QObject {
    Q_OBJECT
public:
    MapActions(const LiveContext& context, MapFeature& map);

    [[nodiscard]] QWidget& keyScans() const;  ///< pane of key scans and decisions about them
    /// Discards the selected robot's goal if it was not sent yet.
    void halt();
    /// Sends the selected robot to @p place, in the map's frame [m].
    void go(const Eigen::Vector3d& place);

private:
    GoTo* m_going = nullptr;
    DecisionsFeature* m_decisions = nullptr;
};

}  // namespace leitstand
