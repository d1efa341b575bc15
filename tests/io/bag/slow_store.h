#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "core/io/bag/writing/bag_store.h"

namespace leitstand::test {

/// A disk that stands still, is full or refuses when the test says so, and otherwise keeps all in memory.
class TestDisk {
public:
    /// Commits wait while this holds.
    void hold(bool held) {
        {
            const std::scoped_lock lock(m_mutex);
            m_held = held;
        }
        m_changed.notify_all();
    }
    /// Waits until @p commits were begun.
    bool waitForCommits(int commits) {
        std::unique_lock lock(m_mutex);
        return m_changed.wait_for(lock, std::chrono::seconds(10), [&] { return m_begun >= commits; });
    }
    /// Waits until so many @p events are kept.
    bool waitForEvents(std::size_t events) {
        std::unique_lock lock(m_mutex);
        return m_changed.wait_for(lock, std::chrono::seconds(10), [&] { return m_events.size() >= events; });
    }
    std::vector<RawEvent> events() {
        const std::scoped_lock lock(m_mutex);
        return m_events;
    }

    std::atomic<bool> full = false, broken = false;
    std::atomic<std::uint64_t> refused = 0;  ///< sequence that can never be written
    std::atomic<std::uint64_t> freeBytes = 1ULL << 40U;

    std::optional<detail::StoreProblem> commit(const detail::BagBatch& batch) {
        std::unique_lock lock(m_mutex);
        ++m_begun;
        m_changed.notify_all();
        m_changed.wait(lock, [this] { return !m_held; });
        using Kind = detail::StoreProblem::Kind;
        if (full) return detail::StoreProblem{Kind::DiskFull, "test.db3: no space", 0};
        if (broken) return detail::StoreProblem{Kind::Failed, "test.db3: input/output error", 0};
        for (std::size_t i = 0; i < batch.events.size(); ++i) {
            if (batch.events[i].sequence == refused) return detail::StoreProblem{Kind::Refused, "refused", i};
        }
        m_events.insert(m_events.end(), batch.events.begin(), batch.events.end());
        m_changed.notify_all();
        return std::nullopt;
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_changed;
    bool m_held = false;
    int m_begun = 0;
    std::vector<RawEvent> m_events;
};

/// What a BagWriter sees of a TestDisk.
class TestStore final : public detail::BagStore {
public:
    explicit TestStore(std::shared_ptr<TestDisk> disk) : m_disk(std::move(disk)) {}
    std::optional<detail::StoreProblem> commit(const detail::BagBatch& batch) override {
        return m_disk->commit(batch);
    }
    std::uint64_t freeBytes() override { return m_disk->freeBytes; }
    std::optional<detail::StoreProblem> close() override { return std::nullopt; }
    const std::filesystem::path& file() const override { return m_file; }
    std::uint64_t earlierSequence() const override { return 0; }

private:
    std::shared_ptr<TestDisk> m_disk;
    std::filesystem::path m_file = "test.db3";
};

}  // namespace leitstand::test
