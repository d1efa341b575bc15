#pragma once

#include <cstdint>
#include <functional>
#include <map>

#include <QKeySequence>
#include <QObject>
#include <QString>

#include "app/window/panes/view_context.h"
#include "core/base/result.h"
#include "core/mapping/live/scan_cleaning.h"
#include "widgets/models/map/key_scan_model.h"

class QAction;

namespace leitstand {

class DecisionsPanel;
class MapGestures;
class MapView;
class RobotsOnMap;
struct MissionState;

/// Lets the operator decide about scans ("key-scans"), and about which area and heights belong to the map.
/// All decisions are in the mission's log.
class DecisionsFeature final : public QObject {
    Q_OBJECT
public:
    DecisionsFeature(const MapContext& context, MapView& view, MapGestures& gestures, RobotsOnMap& robots,
                     QObject* parent);

    [[nodiscard]] QWidget& pane() const;
    [[nodiscard]] const KeyScanModel& scans() const { return m_scans; }
    [[nodiscard]] std::uint64_t chosen() const;  ///< id of a key scan; 0: none

private:
    void addDecisions();
    void addArea();
    QAction& add(const QString& id, const QString& text, const QString& hint, const QKeySequence& keys = {},
                 bool checkable = false);
    void answer(const Result<void>& done);  ///< shows an error
    void toNextUncertain();
    void retry();
    void dragForRetry(bool on);
    void dragForLoop(bool on);
    /// Lets the operator draw where the robot was at the selected scan. Calls @p drawn with the id of the
    /// scan and its pose in the map.
    void dragChosen(const QString& command, const QString& text,
                    const std::function<void(std::uint64_t, const Pose&)>& drawn);
    void rewind();
    void drawArea(bool on);
    void follow(const MissionState& mission);
    /// Updates the command @p id. If @p hint is empty, it is disabled: there is nothing to undo or redo.
    void showUndo(const QString& id, const QString& hint, const QString& text);
    void show();
    void showArea();

    MapContext m_context;
    MapView& m_view;
    MapGestures& m_gestures;
    RobotsOnMap& m_robots;
    KeyScanModel m_scans;
    DecisionsPanel* m_panel;
    std::map<QString, QAction*> m_onChosen;  ///< commands for the selected scan
    MapCrop m_area;                          ///< area that is shown
    std::uint64_t m_newest = 0;              ///< sequence of the newest decision in the mission that is shown
};

}  // namespace leitstand
