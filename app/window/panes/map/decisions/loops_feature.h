#pragma once

#include <cstdint>
#include <optional>

#include <QObject>

#include "app/window/panes/view_context.h"
#include "core/mapping/live/loops/loop_preview.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mission/loops/open_loops.h"

class QAction;

namespace leitstand {

class LoopNotice;
class MapQuestion;
class MapView;
struct LiveMoment;
struct MissionState;

/// Asks the operator about possible loops of the map: whether two places are the same. Passes the answers on,
/// and undoes closed loops.
class LoopsFeature final : public QObject {
    Q_OBJECT
public:
    LoopsFeature(const MapContext& context, MapView& view, QObject* parent);

private:
    void addCommands();
    void answer(bool same);
    void follow(const LiveMoment& moment);
    /// Adds captions to the parts of the map whose pose relative to its first part is unknown.
    void nameParts();
    /// Returns whether the parts of the map that @p loop would join are not joined yet.
    [[nodiscard]] bool areApart(const OpenLoop& loop) const;
    void ask(const std::optional<OpenLoop>& loop);
    /// Shows what would move if the loop in question were closed, as soon as that is computed.
    void showPreview(const MissionState& mission);
    [[nodiscard]] QString question(const MissionState& mission) const;

    MapContext m_context;
    MapView& m_view;
    QAction *m_close = nullptr, *m_refuse = nullptr, *m_open = nullptr;
    MapQuestion* m_question = nullptr;
    LoopNotice* m_notice = nullptr;
    std::optional<OpenLoop> m_asked;
    LoopPreviewPtr m_preview;   ///< preview for m_asked that is shown; null: none yet
    LiveMapPtr m_named;         ///< map whose parts have captions
    std::uint64_t m_shown = 0;  ///< sequence of the newest decision in the mission that is shown
};

}  // namespace leitstand
