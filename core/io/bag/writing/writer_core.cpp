#include "core/io/bag/writing/writer_core.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace leitstand::detail {

using std::chrono::milliseconds;

namespace {

constexpr auto NoSequence = std::numeric_limits<std::uint64_t>::max();

}  // namespace

WriterCore::WriterCore(std::unique_ptr<BagStore> store, const BagWriterSettings& settings,
                       BagWriter::AlarmHandler onAlarm)
    : m_store(std::move(store)),
      m_settings(settings),
      m_onAlarm(std::move(onAlarm)),
      m_queue(settings.droppableQueueBytes, settings.queueBytes),
      m_lastSequence(m_store->earlierSequence()),
      m_lastMetadata(Clock::now()),
      m_writer([this] { run(); }),
      m_watcher([this] { watch(); }) {}

WriterCore::~WriterCore() {
    (void)close();
}

void WriterCore::addTopic(const TopicInfo& topic) {
    {
        const std::scoped_lock lock(m_mutex);
        announce(topic);
    }
    m_wake.notify_one();
}

void WriterCore::announce(const TopicInfo& topic) {
    const TopicUse use{topic.droppable, topic.urgent};
    if (!m_topics.try_emplace({topic.name, topic.type}, use).second) return;
    if (m_newTopics.empty()) m_topicsCame = Clock::now();
    m_newTopics.push_back(topic);
}

void WriterCore::write(RawEvent event) {
    {
        const std::scoped_lock lock(m_mutex);
        const auto known = m_topics.find({event.topic, event.type});
        const TopicUse use = known != m_topics.end() ? known->second : TopicUse{};
        if (event.sequence == 0) event.sequence = m_lastSequence + 1;
        if (m_stopping || event.sequence <= m_lastSequence || !event.cdr) {
            m_queue.drop(event, use.droppable);
            return;
        }
        m_lastSequence = event.sequence;
        if (known == m_topics.end()) announce({.name = event.topic, .type = event.type});
        if (use.urgent) m_urgent = event.sequence;
        m_queue.push(std::move(event), use.droppable, Clock::now());
        if (m_committing || (!use.urgent && m_queue.waitingBytes() < m_settings.commitBytes)) return;
    }
    m_wake.notify_one();
}

bool WriterCore::shallCommit(Clock::time_point now) const {
    if (m_stopping || m_flushing || m_queue.first(NoSequence) <= m_urgent) return true;
    if (now - m_lastMetadata >= m_settings.metadataInterval) return true;
    return m_queue.waitingBytes() >= m_settings.commitBytes || now >= nextCommit(now);
}

WriterCore::Clock::time_point WriterCore::nextCommit(Clock::time_point now) const {
    return std::min(m_queue.oldest(now), m_newTopics.empty() ? now : m_topicsCame) +
           m_settings.commitInterval;
}

std::optional<BagBatch> WriterCore::nextBatch() {
    std::unique_lock lock(m_mutex);
    auto now = Clock::now();
    // write() wakes nobody for an event that can wait.
    for (; !shallCommit(now); now = Clock::now()) {
        m_wake.wait_until(lock, std::min(nextCommit(now), now + m_settings.commitInterval / 4));
    }
    m_oldestTaken = m_queue.oldest(now);
    BagBatch batch;
    batch.topics = std::exchange(m_newTopics, {});
    batch.events = m_queue.take(m_settings.commitBytes);
    m_takenFrom = batch.events.empty() ? NoSequence : batch.events.front().sequence;
    batch.metadata = now - m_lastMetadata >= m_settings.metadataInterval;
    if (batch.metadata) m_lastMetadata = now;
    m_committing = true;
    if (batch.empty()) {
        m_flushing = false;
        m_committing = false;
        m_settled.notify_all();
        if (m_stopping) return std::nullopt;
    }
    return batch;
}

void WriterCore::run() {
    while (auto batch = nextBatch()) {
        if (!batch->empty()) commit(std::move(*batch));
    }
}

void WriterCore::commit(BagBatch batch) {
    while (true) {
        const auto problem = m_store->commit(batch);
        if (!problem) return settle(batch);
        if (problem->kind == StoreProblem::Kind::Refused && problem->event < batch.events.size()) {
            refuse(batch, problem->event);
            continue;
        }
        {
            const std::scoped_lock lock(m_mutex);
            m_failure = problem->text;
            m_diskFull = problem->kind == StoreProblem::Kind::DiskFull;
            m_queue.refuseDroppables(true);
        }
        m_watchWake.notify_one();
        dropPictures(batch);
        if (!waitToRetry()) return giveUp(batch);
    }
}

void WriterCore::settle(const BagBatch& batch) {
    {
        const std::scoped_lock lock(m_mutex);
        for (const RawEvent& event : batch.events) {
            m_queue.settle(event);
            m_writtenBytes += event.cdr->size();
        }
        m_writtenEvents += batch.events.size();
        m_storedTopics += batch.topics.size();
        ++m_commits;
        m_lastCommit = std::chrono::time_point_cast<Time::duration>(std::chrono::system_clock::now());
        m_committing = false;
        m_diskFull = false;
        m_failure.clear();
        m_queue.refuseDroppables(false);
    }
    m_settled.notify_all();
}

void WriterCore::refuse(BagBatch& batch, std::size_t index) {
    const std::scoped_lock lock(m_mutex);
    m_queue.settle(batch.events[index]);
    m_queue.drop(batch.events[index], false);
    batch.events.erase(batch.events.begin() + static_cast<std::ptrdiff_t>(index));
}

void WriterCore::dropPictures(BagBatch& batch) {
    const std::scoped_lock lock(m_mutex);
    std::erase_if(batch.events, [this](const RawEvent& event) {
        const auto topic = m_topics.find({event.topic, event.type});
        if (topic == m_topics.end() || !topic->second.droppable) return false;
        m_queue.settle(event);
        m_queue.drop(event, true);
        return true;
    });
}

bool WriterCore::waitToRetry() {
    std::unique_lock lock(m_mutex);
    if (m_stopping) return false;  // close() must not wait
    m_wake.wait_for(lock, m_settings.retryInterval, [this] { return m_stopping; });
    return true;
}

void WriterCore::giveUp(const BagBatch& batch) {
    {
        const std::scoped_lock lock(m_mutex);
        for (const RawEvent& event : batch.events) {
            m_queue.settle(event);
            m_queue.drop(event, false);
        }
        m_abandoned += batch.events.size();
        m_storedTopics += batch.topics.size();
        m_committing = false;
    }
    m_settled.notify_all();
}

bool WriterCore::isStored(std::uint64_t sequence) const {
    return m_queue.first(NoSequence) > sequence && (!m_committing || m_takenFrom > sequence);
}

Result<void> WriterCore::flush(milliseconds deadline) {
    std::unique_lock lock(m_mutex);
    const std::uint64_t last = m_lastSequence;
    const std::size_t topics = m_topics.size();
    const auto done = [&] { return isStored(last) && m_storedTopics >= topics; };
    m_flushing = true;
    m_wake.notify_one();
    if (m_settled.wait_for(lock, deadline, done)) return {};
    return Error{fmt::format("{}: {} events are not on the disk after {} ms{}{}", m_store->file().string(),
                             m_queue.events(), deadline.count(), m_failure.empty() ? "" : ": ", m_failure)};
}

Result<void> WriterCore::close() {
    {
        const std::scoped_lock lock(m_mutex);
        if (std::exchange(m_closed, true)) return {};
        m_stopping = true;
    }
    m_wake.notify_one();
    m_writer.join();
    {
        const std::scoped_lock lock(m_mutex);
        m_watchStopping = true;
    }
    m_watchWake.notify_one();
    m_watcher.join();
    const auto problem = m_store->close();
    if (m_abandoned > 0) {
        return Error{fmt::format("{}; {} events are lost", m_failure, m_abandoned)};
    }
    if (problem) return Error{problem->text};
    return {};
}

}  // namespace leitstand::detail
