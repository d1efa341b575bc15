#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

struct CheckpointSample;

/// CheckpointSample::version of what this program writes.
inline constexpr std::uint32_t CheckpointVersion = 11;
/// Oldest version that this program reads. Fields that were added later follow the older ones.
inline constexpr std::uint32_t OldestCheckpointVersion = 6;

/// Returns @p state as bytes; equal states make equal bytes.
[[nodiscard]] std::vector<std::byte> serialised(const MissionState& state);
/// Reads a state from @p bytes. Any input is safe: bytes that make no sense give an error.
[[nodiscard]] Result<MissionState> deserialised(std::span<const std::byte> bytes);

/// Returns a checkpoint of @p state for the log.
[[nodiscard]] CheckpointSample checkpointOf(const MissionState& state, Time stamp);
/// Returns the state in @p checkpoint. Error when its version is not supported or it is damaged.
[[nodiscard]] Result<MissionState> stateOf(const CheckpointSample& checkpoint);

}  // namespace leitstand
