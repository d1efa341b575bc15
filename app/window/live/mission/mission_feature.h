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

/// Shows the mission's clock, and whether the mission is recorded.
class MissionFeature final : public QObject {
    Q_OBJECT
public:
    /// @p folder: folder of the mission.
    MissionFeature(const LiveContext& context, const QString& folder);

    /// Returns the widget with clock and recording, for the top bar.
    [[nodiscard]] QWidget* bar() const { return m_bar; }

    /// Offers to continue the mission @p name, which was recorded until a moment ago, instead of this one.
    /// The operator must confirm it. The offer ends after 30 minutes.
    void offerEarlier(const QString& name);

signals:
    void earlierWanted();  ///< the mission of offerEarlier() shall be continued
    /// This mission shall end, and a new one shall begin in the map of the mission @p folder.
    void mapWanted(const QString& folder);

private:
    void addCommands();
    void askForLength();
    void askForEarlier();
    void askForMap();
    /// Asks whether this mission shall end, without blocking. Calls @p ends if the answer is yes.
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
    int m_sinceLog = 0;  ///< number of ticks
};

}  // namespace leitstand
