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

/// Where the map meets itself: what the operator is asked, answers, and takes back.
class LoopsFeature final : public QObject {
    Q_OBJECT
public:
    LoopsFeature(const MapContext& context, MapView& view, QObject* parent);

private:
    void addCommands();
    void answer(bool same);
    void follow(const LiveMoment& moment);
    /// Names the parts of the map of which nobody knows how they lie to its first one.
    void nameParts();
    /// Whether the parts of the map that @p loop would join have not come together otherwise meanwhile.
    [[nodiscard]] bool areApart(const OpenLoop& loop) const;
    void ask(const std::optional<OpenLoop>& loop);
    /// What would move, as soon as that is worked out.
    void showPreview(const MissionState& mission);
    [[nodiscard]] QString question(const MissionState& mission) const;

    MapContext m_context;
    MapView& m_view;
    QAction *m_close = nullptr, *m_refuse = nullptr, *m_open = nullptr;
    MapQuestion* m_question = nullptr;
    LoopNotice* m_notice = nullptr;
    std::optional<OpenLoop> m_asked;
    LoopPreviewPtr m_preview;   ///< of it, that is shown; null: none yet
    LiveMapPtr m_named;         ///< the map whose parts are named
    std::uint64_t m_shown = 0;  ///< sequence of the newest decision of the mission that is shown
};

}  // namespace leitstand
