#pragma once

#include <filesystem>
#include <functional>
#include <thread>

#include <QObject>
#include <QString>
#include <QStringList>

namespace leitstand {

/// Writes the hand-in of the reviewed mission on its own thread, for any of the windows.
class ReviewReport final : public QObject {
    Q_OBJECT
public:
    /// Writes the hand-in of the mission @p folder.
    explicit ReviewReport(std::filesystem::path folder);
    ~ReviewReport() override;  ///< cancels writing; no file is left incomplete

    void begin(const QString& out);  ///< does nothing while a hand-in is being written
    /// Interrupts writing, calls @p change, then starts the interrupted hand-in again from the beginning. So
    /// a hand-in never mixes two languages when the language changes.
    void beginAround(const std::function<void()>& change);
    [[nodiscard]] bool writing() const { return m_writing; }
    [[nodiscard]] double progress() const { return m_progress; }  ///< 0 to 1

signals:
    void changed();                      ///< writing began, progressed or ended
    void notified(const QString& text);  ///< messages for the operator

private:
    void run(const std::stop_token& stop, int attempt);
    void finish(int attempt, const QStringList& words);
    template <class Call>
    void hop(Call call) {
        QMetaObject::invokeMethod(this, std::move(call), Qt::QueuedConnection);
    }

    const std::filesystem::path m_mission;
    QString m_out;
    int m_attempt = 0;  ///< number of the present attempt; notifications of earlier ones are ignored
    bool m_writing = false;
    double m_progress = 0.0;
    std::jthread m_thread;  ///< the last member, so that it ends first
};

}  // namespace leitstand
