#pragma once

#include <cstdint>
#include <span>

#include "app/window/panes/view_context.h"

class QWidget;

namespace leitstand {

class AlarmsFeature;
class CameraFeature;
class CompareFeature;
class DriveFeature;
class FindsFeature;
class JointsFeature;
class LinkFeature;
class MapActions;
class MapFeature;
struct MapViewSettings;
class ScanFeature;
class VictimsFeature;

/// Features of a window's panes that other features use.
struct PaneFeatures {
    CameraFeature* cameras = nullptr;
    MapFeature* map = nullptr;
    ScanFeature* scan = nullptr;
    JointsFeature* joints = nullptr;  ///< null: no robot has flippers or an arm
    // Of a live window only.
    DriveFeature* drive = nullptr;
    MapActions* actions = nullptr;
    VictimsFeature* victims = nullptr;
    LinkFeature* link = nullptr;
    AlarmsFeature* alarms = nullptr;
    // Of a review only.
    FindsFeature* finds = nullptr;
    CompareFeature* compare = nullptr;
};

/// What is needed to make the panes of a window.
struct PaneMaking {
    const ViewContext& view;
    const MapViewSettings& look;            ///< view of the map at the start
    const LiveContext* live = nullptr;      ///< null: it is no live window
    const ReviewContext* review = nullptr;  ///< null: it is no review
    const MapContext* byHand = nullptr;     ///< null: the map is not corrected by hand
    PaneFeatures made = {};                 ///< features that earlier rows of the table made
};

/// One pane: its names, its place, and what makes it in each kind of window.
struct PaneRow {
    using Make = QWidget& (*)(PaneMaking&);
    using Needed = bool (*)(const PaneMaking&);
    enum class Kind : std::uint8_t {
        Plain,
        Kept,   ///< no other pane opens as a tab over it as long as there is another host (keepInSight())
        Sheet,  ///< opens on demand, in the space of a host (addSheet())
    };

    const char* id;     ///< its name in layouts and saved arrangements; never changes
    const char* title;  ///< in English; translated in the context "Panes"
    Make live;          ///< null: a live window has no such pane
    Make review;        ///< null: a review has no such pane
    Kind kind = Kind::Plain;
    /// Sheets open in the space of the visible pane with the lowest rank above 0. If it is 0, this pane is no
    /// host: panes where a driver looks (camera, surroundings, second camera, strip) and the alarms have 0.
    int hostRank = 0;
    const char* formerId = "";  ///< its id in older layouts and arrangements; empty: the same
    Make byHand = nullptr;      ///< null: the window that corrects a map by hand has no such pane
    Needed needed = nullptr;    ///< whether the window's robots need it; null: always
};

/// Returns every pane that a window can have, in the order in which they are made and listed.
[[nodiscard]] std::span<const PaneRow> paneTable();
/// Makes every pane of the table that the window has, and adds it to the window's docks. Features are
/// children of the window, and keep copies of @p context.
[[nodiscard]] PaneFeatures makePanes(const LiveContext& context, const MapViewSettings& look);
[[nodiscard]] PaneFeatures makePanes(const ReviewContext& context, const MapViewSettings& look);
[[nodiscard]] PaneFeatures makePanes(const MapContext& context, const MapViewSettings& look);

}  // namespace leitstand
