#pragma once

#include <QObject>

#include "app/window/panes/view_context.h"
#include "app/window/review/tidy_progress.h"

class QAction;

namespace leitstand {

class MapQuestion;
class MapView;
class ReviewBridge;

/// Commands that tidy the map of a mission, undo the tidying, and show where scans were before it.
class TidyingFeature final : public QObject {
    Q_OBJECT
public:
    TidyingFeature(const ReviewContext& context, MapView& view, QObject* parent);

signals:
    void wanted(leitstand::MapTidying what);

private:
    QAction* add(const char* id, const QString& text, const QString& hint);
    void ask(MapTidying what);
    void follow();
    void compare(bool on);

    const ViewContext m_context;
    ReviewBridge& m_bridge;
    MapView& m_view;
    QAction *m_tidy, *m_back, *m_before;
    MapQuestion* m_notice;
};

}  // namespace leitstand
