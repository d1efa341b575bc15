#pragma once

#include <QObject>
#include <QTimer>

#include "app/window/panes/alarms/tone_player.h"
#include "app/window/panes/view_context.h"
#include "core/station/alarms/alarm_voice.h"

class QAction;

namespace leitstand {

struct LiveMoment;
class AlarmPanel;

/// The alarms: their list ("alarms"), their tones, and the keys that acknowledge and mute.
class AlarmsFeature final : public QObject {
    Q_OBJECT
public:
    explicit AlarmsFeature(const LiveContext& context);

    [[nodiscard]] QWidget& pane() const;
    void tryTones();  ///< plays both tones, one after the other
    /// Returns why tones cannot be heard; empty: they can.
    [[nodiscard]] const QString& soundTrouble() const { return m_player.trouble(); }

signals:
    void soundTroubleChanged(const QString& why);
    /// An alarm has sounded; also emitted if there is no sound device.
    void sounded(leitstand::AlarmTone tone);

private:
    void addCommands();
    void toggleMute();
    void show(const LiveMoment& moment);

    LiveContext m_context;
    AlarmPanel* m_panel;
    QAction* m_acknowledge = nullptr;  ///< enabled while an alarm waits to be acknowledged
    TonePlayer m_player;
    QTimer m_second;  ///< starts the second tone of tryTones(); an alarm's tone cancels it
    AlarmVoice m_voice;
    int m_sinceShown = 0;  ///< number of ticks
};

}  // namespace leitstand
