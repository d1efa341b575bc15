#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <set>

#include <QObject>
#include <QString>

#include "app/services/mapping/submap_fits.h"
#include "app/window/panes/view_context.h"
#include "core/base/pose.h"
#include "core/base/result.h"
#include "core/mapping/live/map/live_map.h"

class QAction;

namespace leitstand {

class MapGestures;
class MapQuestion;
class MapView;
struct GroundDrag;

/// Lets the operator move a part of the map by hand: drag and turn it, snap it, leave it at its new place.
/// Shows how well the part fits the rest of the map.
class SubmapFeature final : public QObject {
    Q_OBJECT
public:
    /// @p chosen: returns the id of the key scan that the operator has selected; 0: none.
    SubmapFeature(const MapContext& context, MapView& view, MapGestures& gestures,
                  std::function<std::uint64_t()> chosen, QObject* parent);

private:
    void addCommands();
    void begin();
    void end();
    void next();  ///< selects another part: more of the map, or less
    /// Begins to move the part given by m_scan and m_kind, starting at m_moved.
    void take();
    void drag(const GroundDrag& drag);
    void moveTo(const Pose& moved);
    void snap();
    void leave();  ///< leaves the part at its present place, so that the map follows
    void left(const Result<std::size_t>& links);
    void follow();
    void show();
    [[nodiscard]] QString what() const;
    [[nodiscard]] QString text() const;
    [[nodiscard]] std::uint64_t scanToMove() const;

    MapContext m_context;
    MapView& m_view;
    MapGestures& m_gestures;
    std::function<std::uint64_t()> m_chosen;
    QAction *m_move = nullptr, *m_more = nullptr, *m_snap = nullptr, *m_leave = nullptr;
    MapQuestion* m_bar = nullptr;
    SubmapFits m_fits;
    bool m_moving = false;
    bool m_snapping = false, m_leaving = false;
    std::uint64_t m_asked = 0;  ///< number of calls of leave(), to ignore answers to earlier ones
    SubmapKind m_kind = SubmapKind::FromHere;
    std::uint64_t m_scan = 0;           ///< key scan that determines the part
    LiveMapPtr m_map;                   ///< map in which the part is moved
    std::set<std::uint64_t> m_submap;   ///< key scans of the part, in m_map
    Pose m_moved = Pose::Identity();    ///< motion of the part: new pose of a scan = m_moved * old pose
    Pose m_grabbed = Pose::Identity();  ///< m_moved when the mouse button was pressed
};

}  // namespace leitstand
