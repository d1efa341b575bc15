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

/// Plays the tones of alarms on the computer's default sound device; where there is none it is silent.
class TonePlayer final : public QObject {
    Q_OBJECT
public:
    explicit TonePlayer(QObject* parent = nullptr);
    ~TonePlayer() override;

    /// Begins @p tone; one that still sounds is cut off.
    void play(AlarmTone tone);
    /// Why nothing is heard, for the operator; empty when all is well.
    [[nodiscard]] const QString& trouble() const { return m_trouble; }

signals:
    void troubleChanged();

private:
    void setTrouble(const QString& trouble);
    void lookForDevice();

    std::unique_ptr<QMediaDevices> m_devices;
    QByteArray m_samples;
    std::unique_ptr<QBuffer> m_buffer;
    std::unique_ptr<QAudioSink> m_sink;  ///< reads the buffer: goes first
    QByteArray m_failed;                 ///< the device that did not play, by its id
    QString m_trouble;
};

}  // namespace leitstand
