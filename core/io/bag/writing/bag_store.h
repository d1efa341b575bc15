#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/event/raw_event.h"
#include "core/io/bag/topic_info.h"

namespace leitstand::detail {

/// Data that is written to the disk together: all of it or nothing.
struct BagBatch {
    std::vector<TopicInfo> topics;  ///< topics that the bag does not have yet
    std::vector<RawEvent> events;   ///< by rising sequence
    bool metadata = false;          ///< also updates the metadata of the bag
    [[nodiscard]] bool empty() const { return topics.empty() && events.empty() && !metadata; }
};

/// Why a batch could not be written.
struct StoreProblem {
    enum class Kind : std::uint8_t {
        DiskFull,  ///< try again when there is space
        Refused,   ///< BagBatch::events[event] can never be written
        Failed,
    };
    Kind kind = Kind::Failed;
    std::string text;       ///< names the file
    std::size_t event = 0;  ///< index of the refused event in BagBatch::events
};

/// Where a BagWriter stores its data: the disk, or in tests a slow or full one. One thread uses it; any other
/// thread may call freeBytes().
class BagStore {
public:
    virtual ~BagStore() = default;
    /// Writes @p batch and waits until it is on the disk (fsync). On failure returns why; nothing of @p batch
    /// is on the disk then. Empty: success.
    [[nodiscard]] virtual std::optional<StoreProblem> commit(const BagBatch& batch) = 0;
    /// Free space that an ordinary user may fill [B].
    [[nodiscard]] virtual std::uint64_t freeBytes() = 0;
    /// Makes the file self-contained and the metadata final.
    [[nodiscard]] virtual std::optional<StoreProblem> close() = 0;
    [[nodiscard]] virtual const std::filesystem::path& file() const = 0;
    /// Last sequence of the earlier sessions.
    [[nodiscard]] virtual std::uint64_t earlierSequence() const = 0;
};

}  // namespace leitstand::detail
