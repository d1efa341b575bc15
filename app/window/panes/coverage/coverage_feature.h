#pragma once

#include <functional>
#include <optional>

#include <QObject>
#include <QTimer>

#include "app/window/panes/view_context.h"
#include "core/mission/coverage/searched_floor.h"

class QAction;
class QActionGroup;

namespace leitstand {

class MapActions;
class MapFeature;
class MissedPanel;
struct LiveMoment;

/// Shows what was searched with each kind of sensor, and what was missed ("missed"), over the map.
class CoverageFeature final : public QObject {
    Q_OBJECT
public:
    /// Returns what was searched until the given moment, as far as it is computed; null: nothing yet. Called
    /// twice a second while the map or the pane shows it.
    using Source = std::function<SearchedFloorPtr(const LiveMoment&)>;

    /// @p actions: sends robots; null: there are no live robots.
    CoverageFeature(const ViewContext& context, MapFeature& map, Source searched,
                    MapActions* actions = nullptr);

    [[nodiscard]] QWidget& pane() const;
    /// Returns the sensor whose searched floor the map shows. Empty: none.
    [[nodiscard]] const std::optional<SearchSensor>& shown() const { return m_shown; }

private:
    void addOverlays();
    [[nodiscard]] QAction* addMissed();
    [[nodiscard]] QAction* addGoTo(MapActions& actions);
    void showOverlay(std::optional<SearchSensor> sensor);
    void showMissed();
    void showChosen();
    void follow();
    void refresh();
    void list();  ///< lists what was missed, with distances from the selected robot

    ViewContext m_context;
    MapFeature& m_map;
    Source m_source;
    MissedPanel* m_panel;
    QActionGroup* m_overlays;
    QAction* m_goTo = nullptr;  ///< null: there are no live robots
    std::optional<SearchSensor> m_shown;
    SearchedFloorPtr m_searched;
    QTimer m_look;
};

}  // namespace leitstand
