#pragma once

#include <cstdint>

#include <QObject>

#include "app/window/live/live_context.h"

class QAction;

namespace leitstand {

class LoopQuestion;
class MapView;
struct MissionState;

/// Where the map meets itself: what the operator is asked, answers, and takes back.
class LoopsFeature final : public QObject {
    Q_OBJECT
public:
    LoopsFeature(const LiveContext& context, MapView& view, QObject* parent);

signals:
    void told(const QString& text);

private:
    void addCommands();
    void answer(bool same);
    void follow(const MissionState& mission);

    LiveContext m_context;
    MapView& m_view;
    QAction *m_close = nullptr, *m_refuse = nullptr, *m_open = nullptr;
    LoopQuestion* m_question = nullptr;
    std::uint64_t m_shown = 0;  ///< sequence of the newest decision of the mission that is shown
};

}  // namespace leitstand
