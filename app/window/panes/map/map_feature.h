#pragma once

#include <functional>

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>

#include "app/window/map/view_state.h"
#include "app/window/panes/view_context.h"
#include "widgets/models/map_summary.h"

namespace leitstand {

class MapGestures;
class MapPane;
class MapView;
class RobotsOnMap;
struct GrantView;
struct LiveMoment;

/// The station that has the @p grant, where that is another one; else empty.
[[nodiscard]] QString othersTitle(const GrantView& grant);

/// The 3D map as it grows ("map"), and how it is looked at.
class MapFeature final : public QObject {
    Q_OBJECT
public:
    MapFeature(const ViewContext& context, const MapViewSettings& view);

    [[nodiscard]] QWidget& pane() const;
    [[nodiscard]] MapView& view() const;
    [[nodiscard]] MapGestures& gestures() const { return *m_gestures; }
    [[nodiscard]] RobotsOnMap& robots() const { return *m_robots; }
    [[nodiscard]] const MapViewSettings& settings() const { return m_view.settings(); }
    [[nodiscard]] MapSight sight() const { return {settings().look, settings().follow}; }
    /// Looks at the map so. A camera that follows nothing is where it was left.
    void show(const MapSight& sight);
    /// The title is what @p how says at a moment, for a map that is shown in place of the source's own;
    /// empty: it is of that again.
    void describe(std::function<MapSummary(const LiveMoment&)> how);
    /// What is not to be seen of the map yet.
    [[nodiscard]] QStringList missing() const;

private:
    void addCommands();
    [[nodiscard]] MapSummary summaryOf(const LiveMoment& moment) const;
    void showSummary(const LiveMoment& moment);
    void showPointed(const QString& point);  ///< empty: none
    void showSummaryNow();

    ViewContext m_context;
    ViewState m_view;
    MapPane* m_pane;
    MapGestures* m_gestures;
    RobotsOnMap* m_robots = nullptr;
    std::function<MapSummary(const LiveMoment&)> m_describe;
    MapPtr m_map;       ///< that is shown; null: none came
    QString m_pointed;  ///< the point under the pointer, in words; empty: none is
    QTimer m_resting;   ///< since the pointer moved
};

}  // namespace leitstand
