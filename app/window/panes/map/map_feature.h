#pragma once

#include <functional>

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>

#include "app/window/map/view_state.h"
#include "app/window/panes/view_context.h"
#include "widgets/models/map_text.h"

namespace leitstand {

class MapGestures;
class MapPane;
class MapView;
class RobotsOnMap;
struct GrantView;
struct LiveMoment;

/// Returns the title of the other station that holds @p grant. Empty: this station holds it, or nobody does.
[[nodiscard]] QString othersTitle(const GrantView& grant);

/// The 3D map ("map") as it grows, and how it is viewed.
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
    /// Shows the map as @p sight describes. A camera that stops following a robot returns to where the
    /// operator left it.
    void show(const MapSight& sight);
    /// Sets @p how, which makes the title while another map is shown instead of the source's own. Empty: the
    /// title describes the source's map again.
    void describe(std::function<MapSummary(const LiveMoment&)> how);
    /// Returns texts about what of the map is not visible yet. Empty when a scan is drawn.
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
    MapPtr m_map;       ///< map that is shown; null: none was received
    QString m_pointed;  ///< text about the point under the pointer; empty: none
    QTimer m_resting;   ///< restarted when the pointer moves; when it ends, m_pointed is no longer shown
};

}  // namespace leitstand
