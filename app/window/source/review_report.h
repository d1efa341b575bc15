#pragma once

#include <filesystem>
#include <functional>
#include <thread>

#include <QObject>
#include <QString>
#include <QStringList>

namespace leitstand {

/// The hand-in of the mission that is reviewed, written on a thread of its own, whatever window it was asked
/// for in.
class ReviewReport final : public QObject {
    Q_OBJECT
public:
    /// Of the mission @p folder.
    explicit ReviewReport(std::filesystem::path folder);
    ~ReviewReport() override;  ///< what is being written is given up; files are whole all the same

    void begin(const QString& out);  ///< nothing while one is being written
    /// Calls @p change while nothing is written. What was being written begins anew after it: a change of
    /// language leaves no hand-in in two of them.
    void beginAnewAround(const std::function<void()>& change);
    [[nodiscard]] bool writing() const { return m_writing; }
    [[nodiscard]] double progress() const { return m_progress; }  ///< 0 to 1

signals:
    void changed();                      ///< it began, went on or is over
    void notified(const QString& text);  ///< what came of it, for the operator

private:
    void run(const std::stop_token& stop, int attempt);
    void finish(int attempt, const QStringList& words);
    template <class Call>
    void hop(Call call) {
        QMetaObject::invokeMethod(this, std::move(call), Qt::QueuedConnection);
    }

    const std::filesystem::path m_mission;
    QString m_out;
    int m_attempt = 0;  ///< what earlier ones still tell is of no interest
    bool m_writing = false;
    double m_progress = 0.0;
    std::jthread m_thread;  ///< last: ends first
};

}  // namespace leitstand
