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

/// Returns the state after @p event; @p state is the state before it. Pure. Pass @p state by move to save
/// copies. Never fails: an event that makes no sense becomes an entry of MissionState::remarks.
[[nodiscard]] MissionState fold(MissionState state, const Event& event);

/// Keeps the state of a mission up to date as events arrive. One thread adds events; snapshots may be used in
/// any thread.
class Fold {
public:
    explicit Fold(MissionState start = {}) : m_state(std::move(start)) {}

    void add(const Event& event);
    [[nodiscard]] const MissionState& state() const { return m_state; }
    /// Returns an immutable copy of the state.
    [[nodiscard]] MissionStatePtr snapshot() const { return std::make_shared<const MissionState>(m_state); }

    /// Returns a checkpoint of the state if events arrived and @p interval has passed since the last
    /// checkpoint; otherwise empty. The caller logs it as an event.
    [[nodiscard]] std::optional<CheckpointSample> dueCheckpoint(
        Time now, std::chrono::nanoseconds interval = std::chrono::seconds(20));

private:
    MissionState m_state;
    Time m_checkpointed{};
    std::uint64_t m_checkpointedSequence = 0;
};

/// Access to the past of a mission for stateAt(): the decoded log.
class MissionHistory {
public:
    struct StoredCheckpoint {
        std::uint64_t sequence = 0;  ///< sequence of the event that contains it
        CheckpointSample checkpoint;
    };
    virtual ~MissionHistory() = default;
    /// Returns the newest checkpoint event up to and including @p sequence; empty when there is none.
    [[nodiscard]] virtual std::optional<StoredCheckpoint> checkpointUpTo(std::uint64_t sequence) = 0;
    /// Calls @p take for each event after @p after, up to and including @p upTo, in order.
    virtual void events(std::uint64_t after, std::uint64_t upTo,
                        const std::function<void(const Event&)>& take) = 0;
};

/// Returns the state after the event with the sequence @p sequence. Starts from the newest readable
/// checkpoint before it and folds the events after that. The result is the same as folding all events from
/// the first.
[[nodiscard]] MissionState stateAt(MissionHistory& history, std::uint64_t sequence);

}  // namespace leitstand
