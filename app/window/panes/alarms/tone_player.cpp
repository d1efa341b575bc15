#include "app/window/panes/alarms/tone_player.h"

#include <algorithm>
#include <cstring>

#include <QAudioDevice>
#include <QAudioFormat>
#include <QAudioSink>
#include <QBuffer>
#include <QMediaDevices>

namespace leitstand {
namespace {

QAudioFormat formatFor(const QAudioDevice& device) {
    QAudioFormat format;
    format.setSampleRate(44'100);
    format.setChannelCount(1);
    format.setSampleFormat(QAudioFormat::Int16);
    return device.isFormatSupported(format) ? format : device.preferredFormat();
}

/// Returns @p samples in @p format, the same in each channel. Empty for formats that are not supported.
QByteArray bytesOf(const std::vector<float>& samples, const QAudioFormat& format) {
    QByteArray bytes;
    const auto add = [&bytes](auto value) {
        char raw[sizeof value];
        std::memcpy(raw, &value, sizeof value);
        bytes.append(raw, sizeof value);
    };
    for (const float sample : samples) {
        for (int channel = 0; channel < format.channelCount(); ++channel) {
            switch (format.sampleFormat()) {
                case QAudioFormat::Int16:
                    add(static_cast<qint16>(32'767.0F * sample));
                    break;
                case QAudioFormat::Int32:
                    add(static_cast<qint32>(2'147'483'000.0 * static_cast<double>(sample)));
                    break;
                case QAudioFormat::Float:
                    add(sample);
                    break;
                case QAudioFormat::UInt8:
                    add(static_cast<quint8>(127.5F + 127.0F * sample));
                    break;
                default:
                    return {};
            }
        }
    }
    return bytes;
}

}  // namespace

TonePlayer::TonePlayer(QObject* parent) : QObject(parent), m_devices(std::make_unique<QMediaDevices>()) {
    connect(m_devices.get(), &QMediaDevices::audioOutputsChanged, this, &TonePlayer::lookForDevice);
    lookForDevice();
}

void TonePlayer::lookForDevice() {
    const QAudioDevice device = QMediaDevices::defaultAudioOutput();
    if (device.isNull()) return setTrouble(tr("No sound device: alarms are seen, not heard."));
    // A device that failed still fails after another one was plugged in or out.
    if (device.id() != m_failed) setTrouble({});
}

TonePlayer::~TonePlayer() {
    if (m_sink) m_sink->stop();
}

void TonePlayer::setTrouble(const QString& trouble) {
    if (trouble == m_trouble) return;
    m_trouble = trouble;
    emit troubleChanged();
}

void TonePlayer::play(AlarmTone tone) {
    const QAudioDevice device = QMediaDevices::defaultAudioOutput();
    if (device.isNull()) return setTrouble(tr("No sound device: alarms are seen, not heard."));
    const QAudioFormat format = formatFor(device);
    if (m_sink) m_sink->stop();
    m_sink = std::make_unique<QAudioSink>(device, format);
    m_samples = bytesOf(toneSamples(tone, format.sampleRate()), format);
    m_buffer = std::make_unique<QBuffer>(&m_samples);
    m_buffer->open(QIODevice::ReadOnly);
    m_sink->start(m_buffer.get());
    const bool failed = m_sink->error() != QAudio::NoError || m_samples.isEmpty();
    m_failed = failed ? device.id() : QByteArray();
    setTrouble(failed ? tr("The sound device does not work: alarms are seen, not heard.") : QString());
}

}  // namespace leitstand
