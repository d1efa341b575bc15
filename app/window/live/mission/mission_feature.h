#pragma once

#include <functional>

#include <QObject>
#include <QString>

#include "app/window/panes/view_context.h"

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

    /// The mission @p name, which was recorded until a moment ago, may be gone on with instead of this one;
    /// who asks for that is asked again. Withdrawn after a while.
    void offerEarlier(const QString& name);

signals:
    void earlierWanted();  ///< of offerEarlier()
    /// This mission is to end, and a new one to begin in the map of the mission @p folder.
    void mapWanted(const QString& folder);

private:
    void addCommands();
    void askForLength();
    void askForEarlier();
    void askForMap();
    /// Asks, without holding anything up, whether this mission is to end.
    void askToEnd(const QString& name, const QString& title, const QString& text, const QString& yes,
                  const std::function<void()>& ends);
    void show(const LiveMoment& moment);

    LiveContext m_context;
    const QString m_folder;
    QString m_earlierName;
    QWidget* m_bar;
    RecordLight* m_light;
    ClockFace* m_face;
    QAction *m_run = nullptr, *m_length = nullptr, *m_reset = nullptr, *m_earlier = nullptr,
            *m_inMap = nullptr;
    int m_sinceLog = 0;  ///< ticks
};

}  // namespace leitstand
