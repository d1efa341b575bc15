#include "app/window/scans/session_bridge.h"

#include <utility>

namespace leitstand {

SessionBridge::SessionBridge(QObject* parent)
    : QObject(parent), m_session(std::make_unique<ScanSession>(listener())) {}

SessionBridge::~SessionBridge() = default;

SessionListener SessionBridge::listener() {
    const auto hop = [this](auto&& call) {
        QMetaObject::invokeMethod(this, std::forward<decltype(call)>(call), Qt::QueuedConnection);
    };
    return {
        .onMap = [this, hop](MapPtr map) { hop([this, map = std::move(map)] { emit mapChanged(map); }); },
        .onProgress = [this](const SessionProgress& progress) { takeProgress(progress); },
        .onMessage =
            [this, hop](const SessionMessage& message) { hop([this, message] { emit notified(message); }); },
        .onFinished =
            [this, hop](const SessionOutcome& outcome) {
                hop([this, outcome] {
                    emit finished(outcome);
                    addJobs(-1);
                });
            },
    };
}

void SessionBridge::takeProgress(const SessionProgress& progress) {
    const std::scoped_lock lock(m_mutex);
    const bool waiting = m_newest.has_value();
    m_newest = progress;
    if (!waiting) QMetaObject::invokeMethod(this, &SessionBridge::showProgress, Qt::QueuedConnection);
}

void SessionBridge::showProgress() {
    std::optional<SessionProgress> newest;
    {
        const std::scoped_lock lock(m_mutex);
        newest.swap(m_newest);
    }
    if (newest) emit progressed(*newest);
}

void SessionBridge::addJobs(int jobs) {
    const bool before = busy();
    m_jobs += jobs;
    if (busy() != before) emit busyChanged(busy());
}

void SessionBridge::open(std::vector<std::filesystem::path> sources, const RegistrationSettings& settings) {
    addJobs(1);
    m_session->open(std::move(sources), settings);
}

void SessionBridge::registerAgain(const RegistrationSettings& settings) {
    addJobs(1);
    m_session->registerAgain(settings);
}

void SessionBridge::clear() {
    addJobs(1);
    m_session->clear();
}

void SessionBridge::cancel() {
    m_session->cancel();
}

}  // namespace leitstand
