#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/event/raw_event.h"
#include "core/io/bag/topic_info.h"

namespace leitstand::detail {

/// What goes to the disk together: all or nothing.
struct BagBatch {
    std::vector<TopicInfo> topics;  ///< new ones
    std::vector<RawEvent> events;   ///< rising sequences
    bool metadata = false;          ///< also updates the metadata of the bag
    [[nodiscard]] bool empty() const { return topics.empty() && events.empty() && !metadata; }
};

/// Why a batch is not on the disk.
struct StoreProblem {
    enum class Kind : std::uint8_t {
        DiskFull,  ///< try again when there is space
        Refused,   ///< BagBatch::events[event] can never be written
        Failed,
    };
    Kind kind = Kind::Failed;
    std::string text;       ///< names the file
    std::size_t event = 0;  ///< index of the refused event
};

/// Where a BagWriter stores its data: the disk, or a slow or full one in tests. One thread uses it; another
/// may call freeBytes().
class BagStore {
public:
    virtual ~BagStore() = default;
    /// Brings @p batch to the disk (fsync). Returns why that failed, with nothing of @p batch on the disk;
    /// empty: success.
    [[nodiscard]] virtual std::optional<StoreProblem> commit(const BagBatch& batch) = 0;
    /// Free space that an ordinary user may fill [B].
    [[nodiscard]] virtual std::uint64_t freeBytes() = 0;
    /// Makes the file self-contained and the metadata final.
    [[nodiscard]] virtual std::optional<StoreProblem> close() = 0;
    [[nodiscard]] virtual const std::filesystem::path& file() const = 0;
    /// Last sequence of the sessions before this one.
    [[nodiscard]] virtual std::uint64_t earlierSequence() const = 0;
};

}  // namespace leitstand::detail
