#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>
#include <QKeySequence>
#include <QObject>

#include "app/services/finds/freezing.h"
#include "app/window/panes/view_context.h"
#include "core/event/find_sample.h"

class QAction;

namespace leitstand {

class CameraFeature;
class MapFeature;
class ScanFeature;

/// Files finds at which the operator points. A click with Shift into a picture or the virtual scan files a
/// victim. After the command "victim.point", the next click there or on the map does so, too.
/// "victim.pointHazard", "victim.pointCode" and "victim.pointObject" do the same for other finds.
class FindPointing final : public QObject {
    Q_OBJECT
public:
    FindPointing(const LiveContext& context, MapFeature& map, CameraFeature& cameras, ScanFeature& scan);

private:
    void add(const char* id, FindSample::Kind kind, const QString& text, const QString& hint,
             const QKeySequence& keys = {});
    void arm(QAction& action, FindSample::Kind kind, bool on);
    [[nodiscard]] bool armed() const;
    [[nodiscard]] FindSample::Kind kind() const;  ///< kind that the next click files
    void fileIn(const PicturePoint& at);
    void fileBeside(const Eigen::Vector2d& placeInBase);
    void fileAt(const Eigen::Vector3d& placeInMap, FindSample::Kind kind);

    LiveContext m_context;
    MapFeature& m_map;
    CameraFeature& m_cameras;
    ScanFeature& m_scan;
    std::vector<std::pair<FindSample::Kind, QAction*>> m_actions;
};

}  // namespace leitstand
