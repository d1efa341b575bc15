#pragma once

#include <utility>
#include <vector>

#include <QKeySequence>
#include <QObject>

#include "app/services/finds/freezing.h"
#include "app/window/panes/view_context.h"
#include "core/event/find_sample.h"

class QAction;

namespace leitstand {

class CameraFeature;
class FindsFeature;
class MapFeature;
class ReviewBridge;
class ScanFeature;

/// Edits the finds of a review by clicks. "review.move" moves the selected find to where the map is clicked.
/// "review.file", "review.fileHazard", "review.fileCode" and "review.fileObject" file a new find where the
/// map, a picture or the virtual scan is clicked. The pictures of that moment become its evidence. In
/// pictures and the virtual scan, a click with Shift always files a victim.
class FindsByClick final : public QObject {
    Q_OBJECT
public:
    FindsByClick(const ReviewContext& context, MapFeature& map, CameraFeature& cameras, ScanFeature& scan,
                 FindsFeature& finds);

private:
    QAction& add(const char* id, const QString& text, const QString& hint, const QKeySequence& keys = {});
    void addFiling(const char* id, FindSample::Kind kind, const QString& text, const QString& brief = {},
                   const QKeySequence& keys = {});
    void move(QAction& by, bool on);
    void file(QAction& by, FindSample::Kind kind, bool on);
    void fileAt(FindSample::Kind kind, const Eigen::Vector3d& placeInMap);
    void fileIn(const PicturePoint& at);
    void fileBeside(const Eigen::Vector2d& placeInBase);
    void end();                                   ///< ends the present command
    [[nodiscard]] FindSample::Kind kind() const;  ///< kind of find that a click outside the map files
    [[nodiscard]] bool armed() const;

    ViewContext m_context;
    ReviewBridge& m_bridge;
    MapFeature& m_map;
    CameraFeature& m_cameras;
    ScanFeature& m_scan;
    FindsFeature& m_finds;
    std::vector<std::pair<FindSample::Kind, QAction*>> m_filing;
};

}  // namespace leitstand
