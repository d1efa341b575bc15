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

/// The operator moves a part of the map by hand to where it belongs: drags and turns it, sees how it lies
/// on the rest, snaps it, and leaves it there.
class SubmapFeature final : public QObject {
    Q_OBJECT
public:
    /// @p chosen: the key scan that the operator has chosen; 0: none.
    SubmapFeature(const MapContext& context, MapView& view, MapGestures& gestures,
                  std::function<std::uint64_t()> chosen, QObject* parent);

private:
    void addCommands();
    void begin();
    void end();
    void next();  ///< more of the map, or less
    /// Takes up what is moved as of the scan and the kind that are chosen, where it is.
    void take();
    void drag(const GroundDrag& drag);
    void moveTo(const Pose& moved);
    void snap();
    void leave();  ///< it where it is: the map follows
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
    std::uint64_t m_asked = 0;  ///< times that it was left somewhere: answers to earlier ones are late
    SubmapKind m_kind = SubmapKind::FromHere;
    std::uint64_t m_scan = 0;           ///< by which it is chosen
    LiveMapPtr m_map;                   ///< in which it is moved
    std::set<std::uint64_t> m_submap;   ///< in it
    Pose m_moved = Pose::Identity();    ///< to put before the poses of its scans
    Pose m_grabbed = Pose::Identity();  ///< likewise, when the mouse went down
};

}  // namespace leitstand
