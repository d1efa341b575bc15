#pragma once

#include <Eigen/Core>
#include <QObject>

#include "app/window/live/live_context.h"

namespace leitstand {

class GoTo;
class MapFeature;

/// What the operator does on the map with live robots and their scans: sends them, places them, decides.
class MapActions final : public QObject {
    Q_OBJECT
public:
    MapActions(const LiveContext& context, MapFeature& map);

    /// A robot that was not yet sent to a place stays.
    void halt();
    /// Sends the selected robot to @p place of the map [m].
    void go(const Eigen::Vector3d& place);

signals:
    void told(const QString& text);

private:
    GoTo* m_going = nullptr;
};

}  // namespace leitstand
