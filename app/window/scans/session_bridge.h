#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include <QObject>

#include "app/services/offline/scan_session.h"

namespace leitstand {

/// A ScanSession for the GUI thread. Reports of the session's thread arrive here as signals, in order. Of
/// several reports about progress, only the newest arrives.
class SessionBridge final : public QObject {
    Q_OBJECT
public:
    explicit SessionBridge(QObject* parent = nullptr);
    /// Cancels all work and waits for the session's thread.
    ~SessionBridge() override;

    void open(std::vector<std::filesystem::path> sources, const RegistrationSettings& settings);
    void registerAgain(const RegistrationSettings& settings);
    void clear();
    void cancel();
    /// Returns whether jobs are running or waiting.
    [[nodiscard]] bool busy() const { return m_jobs > 0; }

signals:
    void mapChanged(const leitstand::MapPtr& map);
    void progressed(const leitstand::SessionProgress& progress);
    void notified(const leitstand::SessionMessage& message);
    void finished(const leitstand::SessionOutcome& outcome);
    void busyChanged(bool busy);

private:
    [[nodiscard]] SessionListener listener();
    void takeProgress(const SessionProgress& progress);
    void showProgress();
    void addJobs(int jobs);

    int m_jobs = 0;
    std::mutex m_mutex;
    std::optional<SessionProgress> m_newest;  ///< not yet shown; guarded by m_mutex
    std::unique_ptr<ScanSession> m_session;   ///< the last member, so that its thread ends first
};

}  // namespace leitstand
