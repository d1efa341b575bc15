#pragma once

#include <optional>

#include <QObject>

#include "app/window/live/live_context.h"
#include "core/mission/coverage/coverage_map.h"

class QAction;
class QActionGroup;

namespace leitstand {

class MapActions;
class MapFeature;
class MissedPanel;
struct LiveMoment;

/// What was searched with each kind of sensor, over the map, and what was missed ("missed").
class CoverageFeature final : public QObject {
    Q_OBJECT
public:
    CoverageFeature(const LiveContext& context, MapFeature& map, MapActions& actions);

    /// What the map shows; empty: nothing.
    [[nodiscard]] const std::optional<SearchSensor>& shown() const { return m_shown; }

signals:
    void told(const QString& text);

private:
    void addOverlays();
    void addMissed(MapActions& actions);
    void showOverlay(std::optional<SearchSensor> sensor);
    void showMissed();
    void showChosen();
    void follow(const LiveMoment& moment);
    void refresh();
    void list();  ///< what was missed, from where the selected robot is now

    LiveContext m_context;
    MapFeature& m_map;
    MissedPanel* m_panel;
    QActionGroup* m_overlays;
    QAction* m_goTo = nullptr;
    std::optional<SearchSensor> m_shown;
    CoverageMapPtr m_coverage;
    int m_ticks = 0;
};

}  // namespace leitstand
