#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

#include "core/base/time.h"
#include "core/event/event.h"
#include "core/event/station_samples.h"
#include "core/mission/state/checkpoint/checkpoint.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

/// Returns the state after @p event; @p state is the one before. Pure. Moving @p state in saves copies. Never
/// fails: what makes no sense becomes an entry of MissionState::remarks.
[[nodiscard]] MissionState fold(MissionState state, const Event& event);

/// Keeps the state of a mission as its events arrive. One thread adds; snapshots may go to any thread.
class Fold {
public:
    explicit Fold(MissionState start = {}) : m_state(std::move(start)) {}

    void add(const Event& event);
    [[nodiscard]] const MissionState& state() const { return m_state; }
    /// Returns an immutable copy for others.
    [[nodiscard]] MissionStatePtr snapshot() const { return std::make_shared<const MissionState>(m_state); }

    /// Returns a checkpoint of the state when events arrived and @p interval passed since the last
    /// checkpoint; otherwise empty. The caller logs it as an event.
    [[nodiscard]] std::optional<CheckpointSample> dueCheckpoint(
        Time now, std::chrono::nanoseconds interval = std::chrono::seconds(20));

private:
    MissionState m_state;
    Time m_checkpointed{};
    std::uint64_t m_checkpointedSequence = 0;
};

/// The source of the past for stateAt(): the decoded log.
class MissionHistory {
public:
    struct StoredCheckpoint {
        std::uint64_t sequence = 0;  ///< of the event that holds it
        CheckpointSample checkpoint;
    };
    virtual ~MissionHistory() = default;
    /// Returns the newest checkpoint event up to and including @p sequence; empty when there is none.
    [[nodiscard]] virtual std::optional<StoredCheckpoint> checkpointUpTo(std::uint64_t sequence) = 0;
    /// Calls @p take in order for each event after @p after, up to and including @p upTo.
    virtual void events(std::uint64_t after, std::uint64_t upTo,
                        const std::function<void(const Event&)>& take) = 0;
};

/// Returns the state after the event of @p sequence. Starts from the nearest readable checkpoint and folds
/// the events after it. The result equals folding all events from the first on.
[[nodiscard]] MissionState stateAt(MissionHistory& history, std::uint64_t sequence);

}  // namespace leitstand
