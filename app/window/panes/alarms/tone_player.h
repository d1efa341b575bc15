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

/// Plays the tones of alarms on the computer's default sound device. Silent when there is none.
class TonePlayer final : public QObject {
    Q_OBJECT
public:
    explicit TonePlayer(QObject* parent = nullptr);
    ~TonePlayer() override;

    /// Starts @p tone, and cuts off one that still sounds.
    void play(AlarmTone tone);
    /// Returns why nothing is heard, for the operator. Empty when all is well.
    [[nodiscard]] const QString& trouble() const { return m_trouble; }

signals:
    void troubleChanged();

private:
    void setTrouble(const QString& trouble);
    void lookForDevice();

    std::unique_ptr<QMediaDevices> m_devices;
    QByteArray m_samples;
    std::unique_ptr<QBuffer> m_buffer;
    std::unique_ptr<QAudioSink> m_sink;  ///< reads the buffer: destroyed first
    QByteArray m_failed;                 ///< id of the device that did not play
    QString m_trouble;
};

}  // namespace leitstand
