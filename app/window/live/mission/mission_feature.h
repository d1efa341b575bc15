#pragma once

#include <QObject>
#include <QString>

#include "app/window/live/live_context.h"

class QAction;
class QWidget;

namespace leitstand {

class ClockFace;
class RecordLight;
struct LiveMoment;

/// The mission itself: whether it is recorded, and its clock.
class MissionFeature final : public QObject {
    Q_OBJECT
public:
    /// @p folder: of the mission.
    MissionFeature(const LiveContext& context, const QString& folder);

    /// Clock and recording, for the top bar.
    [[nodiscard]] QWidget* bar() const { return m_bar; }

    /// A mission that was recorded until a moment ago may be gone on with, instead of this one.
    void offerEarlier();

signals:
    void told(const QString& text);
    void earlierWanted();  ///< of offerEarlier()

private:
    void addCommands();
    void askForLength();
    void show(const LiveMoment& moment);

    LiveContext m_context;
    const QString m_folder;
    QWidget* m_bar;
    RecordLight* m_light;
    ClockFace* m_face;
    QAction *m_run = nullptr, *m_length = nullptr, *m_reset = nullptr, *m_earlier = nullptr;
    int m_sinceLog = 0;  ///< ticks
};

}  // namespace leitstand
