#pragma once

#include <Eigen/Core>
#include <QObject>

#include "app/session/finds/freezing.h"
#include "app/window/live/live_context.h"

class QAction;

namespace leitstand {

class CameraFeature;
class MapFeature;
class ScanFeature;

/// Victims that the operator points to: Shift and a click into a picture or the virtual scan, or the command
/// "victim.point", after which the next click there or on the map does.
class FindPointing final : public QObject {
    Q_OBJECT
public:
    FindPointing(const LiveContext& context, MapFeature& map, CameraFeature& cameras, ScanFeature& scan);

signals:
    void told(const QString& text);

private:
    void arm(bool on);
    void fileIn(const PicturePoint& at);
    void fileBeside(const Eigen::Vector2d& placeInBase);
    void fileAt(const Eigen::Vector3d& placeInMap);

    LiveContext m_context;
    MapFeature& m_map;
    CameraFeature& m_cameras;
    ScanFeature& m_scan;
    QAction* m_action;
};

}  // namespace leitstand
