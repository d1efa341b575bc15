#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/event/station_samples.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

/// CheckpointSample::version of the bytes that this program writes ...
inline constexpr std::uint32_t CheckpointVersion = 8;
/// ... and of the oldest that it reads: what was added since stands behind what they have.
inline constexpr std::uint32_t OldestCheckpointVersion = 6;

/// @p state as bytes; equal states make equal bytes.
[[nodiscard]] std::vector<std::byte> serialised(const MissionState& state);
/// The state that @p bytes hold; an error, never more, whatever they are.
[[nodiscard]] Result<MissionState> deserialised(std::span<const std::byte> bytes);

/// A checkpoint of @p state for the log.
[[nodiscard]] CheckpointSample checkpointOf(const MissionState& state, Time stamp);
/// The state of @p checkpoint; an error when it is of another version or broken.
[[nodiscard]] Result<MissionState> stateOf(const CheckpointSample& checkpoint);

}  // namespace leitstand
