#pragma once

#include <QKeySequence>
#include <QObject>

#include "app/window/live/live_context.h"
#include "core/robot/samples/victim_sample.h"

class QAction;

namespace leitstand {

class FindsFeature;
class MapFeature;
class ReviewBridge;

/// What a review does to finds by a click on the map: the chosen one is moved there ("review.move"), or one
/// that nobody had filed is ("review.file", "review.fileHazard", "review.fileCode", "review.fileObject"),
/// with the pictures of the moment as evidence.
class FindsOnMap final : public QObject {
    Q_OBJECT
public:
    FindsOnMap(const ViewContext& context, ReviewBridge& bridge, MapFeature& map, FindsFeature& finds);

private:
    QAction& add(const char* id, const QString& text, const QString& hint, const QKeySequence& keys = {});
    void addFiling(const char* id, VictimSample::Kind kind, const QString& text, const QString& brief = {},
                   const QKeySequence& keys = {});
    void move(QAction& by, bool on);
    void file(QAction& by, VictimSample::Kind kind, bool on);
    void fileAt(VictimSample::Kind kind, const Eigen::Vector3d& placeInMap);

    ViewContext m_context;
    ReviewBridge& m_bridge;
    MapFeature& m_map;
    FindsFeature& m_finds;
};

}  // namespace leitstand
