#pragma once

#include <memory>

#include <QByteArray>
#include <QObject>
#include <QString>

#include "core/station/alarms/alarm_tone.h"

class QAudioSink;
class QBuffer;
class QMediaDevices;

namespace leitstand {

/// Plays the tones of alarms on the computer's default sound device. Silent if there is none.
class TonePlayer final : public QObject {
    Q_OBJECT
public:
    explicit TonePlayer(QObject* parent = nullptr);
    ~TonePlayer() override;

    /// Plays @p tone; a tone that is still playing is cut off.
    void play(AlarmTone tone);
    /// Returns why nothing can be heard, for the operator; empty: there is no problem.
    [[nodiscard]] const QString& trouble() const { return m_trouble; }

signals:
    void troubleChanged();

private:
    void setTrouble(const QString& trouble);
    void lookForDevice();

    std::unique_ptr<QMediaDevices> m_devices;
    QByteArray m_samples;
    std::unique_ptr<QBuffer> m_buffer;
    std::unique_ptr<QAudioSink> m_sink;  ///< reads the buffer, so it must be destroyed first
    QByteArray m_failed;                 ///< id of the device that did not play
    QString m_trouble;
};

}  // namespace leitstand
