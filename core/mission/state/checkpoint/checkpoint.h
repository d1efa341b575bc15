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

/// CheckpointSample::version of the bytes that this program writes.
inline constexpr std::uint32_t CheckpointVersion = 8;
/// Oldest version that this program reads. Fields that were added since then come after the older ones.
inline constexpr std::uint32_t OldestCheckpointVersion = 6;

/// Returns @p state as bytes; equal states make equal bytes.
[[nodiscard]] std::vector<std::byte> serialised(const MissionState& state);
/// Returns the state that @p bytes hold. Any input is safe: bytes that make no sense give an error.
[[nodiscard]] Result<MissionState> deserialised(std::span<const std::byte> bytes);

/// Returns a checkpoint of @p state for the log.
[[nodiscard]] CheckpointSample checkpointOf(const MissionState& state, Time stamp);
/// Returns the state of @p checkpoint. Error when it has another version or is broken.
[[nodiscard]] Result<MissionState> stateOf(const CheckpointSample& checkpoint);

}  // namespace leitstand
