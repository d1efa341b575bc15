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

/// What was searched with each kind of sensor, over the map, and what was missed ("missed").
class CoverageFeature final : public QObject {
    Q_OBJECT
public:
    /// Tells what was searched by a moment, as known by now; is asked while somebody looks.
    using Source = std::function<SearchedFloorPtr(const LiveMoment&)>;

    /// @p actions: send robots; null: there are none to be sent.
    CoverageFeature(const ViewContext& context, MapFeature& map, Source searched,
                    MapActions* actions = nullptr);

    [[nodiscard]] QWidget& pane() const;
    /// What the map shows; empty: nothing.
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
    void list();  ///< what was missed, from where the selected robot is now

    ViewContext m_context;
    MapFeature& m_map;
    Source m_source;
    MissedPanel* m_panel;
    QActionGroup* m_overlays;
    QAction* m_goTo = nullptr;  ///< null: there are no robots to be sent
    std::optional<SearchSensor> m_shown;
    SearchedFloorPtr m_searched;
    QTimer m_look;
};

}  // namespace leitstand
