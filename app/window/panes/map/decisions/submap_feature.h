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

/// Lets the operator move a part of the map by hand to where it belongs: drag and turn it, snap it, leave it
/// there. Shows how it lies on the rest.
class SubmapFeature final : public QObject {
    Q_OBJECT
public:
    /// @p chosen: returns the key scan that the operator has chosen; 0: none.
    SubmapFeature(const MapContext& context, MapView& view, MapGestures& gestures,
                  std::function<std::uint64_t()> chosen, QObject* parent);

private:
    void addCommands();
    void begin();
    void end();
    void next();  ///< moves more of the map, or less
    /// Takes up the part for the chosen scan and kind, where it is.
    void take();
    void drag(const GroundDrag& drag);
    void moveTo(const Pose& moved);
    void snap();
    void leave();  ///< leaves it where it is: the map follows
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
    std::uint64_t m_asked = 0;  ///< counts leave(): answers to earlier ones are late
    SubmapKind m_kind = SubmapKind::FromHere;
    std::uint64_t m_scan = 0;           ///< key scan by which the part is chosen
    LiveMapPtr m_map;                   ///< map in which it is moved
    std::set<std::uint64_t> m_submap;   ///< its key scans in m_map
    Pose m_moved = Pose::Identity();    ///< its motion, multiplied from the left to the poses of its scans
    Pose m_grabbed = Pose::Identity();  ///< m_moved when the mouse went down
};

}  // namespace leitstand
